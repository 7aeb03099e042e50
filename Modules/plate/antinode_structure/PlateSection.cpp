#include "PlateSection.h"

#include <algorithm>
#include <iterator>

namespace antinode
{
std::vector<SectionLayer> plateLayers (const StructureCommon& common)
{
    if (common.layers.empty())
        return { elasticLayer (common.material, common.thickness) };

    std::vector<SectionLayer> layers;

    for (const auto& layer : common.layers)
    {
        const auto* soft = std::get_if<ViscoelasticMaterial> (&layer.material);
        layers.push_back (soft ? softLayer (*soft, layer.thickness, common.reference.angularFrequency)
                               : elasticLayer (std::get<ElasticMaterial> (layer.material), layer.thickness));
    }

    return layers;
}

namespace
{
std::vector<SectionLayer> gluedLayers (const CeramicDescription& ceramic, double voltage, double angle,
                                       bool withCeramic)
{
    std::vector<SectionLayer> layers;

    if (ceramic.carrier)
        layers.push_back (elasticLayer (ceramic.carrier->material, ceramic.carrier->thickness));

    if (withCeramic)
        layers.push_back (piezoelectricLayer (ceramic.material, ceramic.thickness, voltage, angle));

    return layers;
}

/** Glue and what is glued to one side, from the plate outwards. */
std::vector<SectionLayer> mounted (const CeramicDescription& ceramic, double voltage, double angle,
                                   const StackParts& parts)
{
    std::vector<SectionLayer> layers;

    if (ceramic.glue)
        layers.push_back (elasticLayer (ceramic.glue->material, ceramic.glue->thickness));

    if (! parts.isBonded)
    {
        SectionLayer gap; // Of no thickness, it hands no shear over.
        gap.softShearModulus = 0;
        layers.push_back (gap);
    }

    const auto glued = gluedLayers (ceramic, voltage, angle, parts.withCeramic);
    layers.insert (layers.end(), glued.begin(), glued.end());
    return layers;
}
} // namespace

std::vector<SectionLayer> gluedLayers (const CeramicDescription& ceramic, bool withCeramic)
{
    return gluedLayers (ceramic, 0, 0, withCeramic);
}

std::vector<SectionLayer> stackLayers (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                                       const StackParts& parts)
{
    const auto isPair = ceramic.mounting == CeramicMounting::bothSides;
    const auto voltage = ceramic.polarity * (isPair && ceramic.wiring == CeramicWiring::series ? 0.5 : 1.0);
    auto layers = plateLayers (common);
    const auto above = mounted (ceramic, voltage, angle, parts);
    std::copy (above.begin(), above.end(), std::back_inserter (layers));

    // The one below strains the other way.
    if (isPair)
    {
        const auto below = mounted (ceramic, -voltage, angle, parts);
        layers.insert (layers.begin(), below.rbegin(), below.rend());
    }

    return layers;
}

LayeredSection sectionWith (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                            const StackParts& parts)
{
    return layeredSection (stackLayers (common, ceramic, angle, parts), common.reference.waveNumber);
}

PlateSection alongAxes (const LayeredSection& section)
{
    const Eigen::Matrix3d stiffness = section.stiffness.real();
    const Eigen::Vector3d moment = section.momentPerVolt.real();
    return { section.massPerArea, stiffness (0, 0), stiffness (1, 1), stiffness (0, 1),
             stiffness (2, 2),    moment[0],        moment[1] };
}

LayeredSection bareStack (const StructureCommon& common)
{
    return layeredSection (plateLayers (common), common.reference.waveNumber);
}

PlateSection bareSection (const StructureCommon& common)
{
    return alongAxes (bareStack (common));
}

PlateSection ceramicSection (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return alongAxes (sectionWith (common, ceramic, 0));
}
} // namespace antinode
