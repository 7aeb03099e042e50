#include "PlateSection.h"

#include <algorithm>
#include <iterator>

namespace antinode
{
namespace
{
std::vector<SectionLayer> substrate (const StructureCommon& common)
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

/** What is glued to one side, from the plate outwards. @param withCeramic  false: a bender's disc without it */
std::vector<SectionLayer> mounted (const CeramicDescription& ceramic, double voltage, double angle, bool withCeramic)
{
    std::vector<SectionLayer> layers;

    if (ceramic.glue)
        layers.push_back (elasticLayer (ceramic.glue->material, ceramic.glue->thickness));

    if (ceramic.carrier)
        layers.push_back (elasticLayer (ceramic.carrier->material, ceramic.carrier->thickness));

    if (withCeramic)
        layers.push_back (piezoelectricLayer (ceramic.material, ceramic.thickness, voltage, angle));

    return layers;
}

LayeredSection stackWith (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                          bool withCeramic)
{
    const auto isPair = ceramic.mounting == CeramicMounting::bothSides;
    const auto voltage = ceramic.polarity * (isPair && ceramic.wiring == CeramicWiring::series ? 0.5 : 1.0);
    auto layers = substrate (common);
    const auto above = mounted (ceramic, voltage, angle, withCeramic);
    std::copy (above.begin(), above.end(), std::back_inserter (layers));

    // The one below strains the other way.
    if (isPair)
    {
        const auto below = mounted (ceramic, -voltage, angle, withCeramic);
        layers.insert (layers.begin(), below.rbegin(), below.rend());
    }

    return layeredSection (layers, common.reference.waveNumber);
}

PlateSection alongAxes (const LayeredSection& section)
{
    const Eigen::Matrix3d stiffness = section.stiffness.real();
    const Eigen::Vector3d moment = section.momentPerVolt.real();
    return { section.massPerArea, stiffness (0, 0), stiffness (1, 1), stiffness (0, 1),
             stiffness (2, 2),    moment[0],        moment[1] };
}
} // namespace

LayeredSection bareStack (const StructureCommon& common)
{
    return layeredSection (substrate (common), common.reference.waveNumber);
}

LayeredSection ceramicStack (const StructureCommon& common, const CeramicDescription& ceramic, double angle)
{
    return stackWith (common, ceramic, angle, true);
}

LayeredSection carrierStack (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return stackWith (common, ceramic, 0, false);
}

PlateSection bareSection (const StructureCommon& common)
{
    return alongAxes (bareStack (common));
}

PlateSection ceramicSection (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return alongAxes (ceramicStack (common, ceramic, 0));
}
} // namespace antinode
