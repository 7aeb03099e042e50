#include "BeamSection.h"

#include "CeramicBond.h"

#include <antinode_numerics/Legendre.h>

#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
/** A layer across a beam, its middle counted from that of the substrate. */
struct BeamLayer
{
    double youngsModulus = 0, shearModulus = 0, density = 0, width = 0, thickness = 0, middle = 0;

    double stretching() const { return youngsModulus * width * thickness; }
    double mass() const { return density * width * thickness; }
};

using BeamLayers = std::vector<BeamLayer>; ///< From the bottom up.

constexpr double shearFactor = 5.0 / 6; ///< Of a rectangle.

/** Where the neutral axis is: how far a ceramic on one side moves it out of the substrate's mid-plane, z_n. */
double neutralAxis (const BeamLayers& layers)
{
    double stretching = 0, coupling = 0;

    for (const auto& layer : layers)
    {
        stretching += layer.stretching();
        coupling += layer.stretching() * layer.middle;
    }

    return coupling / stretching;
}

/** The energy of the shear stress that balances a bending moment as it grows along the beam (Jourawski), as a
   stiffness: 5/6 G A of a rectangle. */
double shearStiffness (const BeamLayers& layers, double axis, double bendingStiffness)
{
    const auto rule = gaussLobattoRule (4); // Of a polynomial of the fourth degree.
    double below = 0, compliance = 0;

    for (const auto& layer : layers)
    {
        const auto bottom = layer.middle - layer.thickness / 2 - axis;
        const Eigen::ArrayXd height = layer.thickness / 2 * (rule.places.array() + 1);
        const Eigen::ArrayXd flow =
            below
            + layer.youngsModulus * layer.width * height * (bottom + height / 2); // Of a curvature of 1 per length.
        compliance +=
            (rule.weights.array() * flow.square()).sum() * layer.thickness / 2 / (layer.shearModulus * layer.width);
        below += layer.stretching() * (layer.middle - axis);
    }

    return bendingStiffness * bendingStiffness / compliance;
}

BeamSection sectionOf (const BeamLayers& layers, BendingTheory theory)
{
    BeamSection section;
    const auto axis = neutralAxis (layers);

    for (const auto& layer : layers)
    {
        const auto square = (layer.middle - axis) * (layer.middle - axis) + layer.thickness * layer.thickness / 12;
        section.massPerLength += layer.mass();
        section.bendingStiffness += layer.stretching() * square;
        section.axialStiffness += layer.stretching();

        if (theory == BendingTheory::thick)
            section.rotaryInertia += layer.mass() * square;
    }

    if (theory == BendingTheory::thick)
        section.shearStiffness = shearStiffness (layers, axis, section.bendingStiffness);

    return section;
}

double glueThickness (const CeramicDescription& ceramic)
{
    return ceramic.glue ? ceramic.glue->thickness : 0;
}

/** From the substrate's mid-plane to that of a ceramic, d. */
double midPlaneDistance (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return (common.thickness + ceramic.thickness) / 2 + glueThickness (ceramic);
}

BeamLayer substrateLayer (const StructureCommon& common, double width)
{
    return { common.material.youngsModulus1,
             common.material.shearModulus,
             common.material.density,
             width,
             common.thickness,
             0 };
}

BeamLayer ceramicLayer (const StructureCommon& common, const CeramicDescription& ceramic, int side)
{
    return { ceramic.material.youngsModulus,
             ceramic.material.shearModulus(),
             ceramic.material.density,
             ceramic.sizeY,
             ceramic.thickness,
             side * midPlaneDistance (common, ceramic) };
}

BeamLayers layersOf (const StructureCommon& common, double width, const CeramicDescription& ceramic,
                     bool withCeramics = true)
{
    BeamLayers layers { substrateLayer (common, width) };

    for (const auto side : { 1, -1 })
    {
        if (side < 0 && ceramic.mounting == CeramicMounting::oneSide)
            break;

        const auto add = [&] (const BeamLayer& layer)
        { layers.insert (side > 0 ? layers.end() : layers.begin(), layer); };

        if (const auto& glue = ceramic.glue)
            add ({ glue->material.youngsModulus1, glue->material.shearModulus, glue->material.density, ceramic.sizeY,
                   glue->thickness, side * (common.thickness + glue->thickness) / 2 });

        if (withCeramics)
            add (ceramicLayer (common, ceramic, side));
    }

    return layers;
}
} // namespace

BeamSection bareSection (const StructureCommon& common, double width)
{
    return sectionOf ({ substrateLayer (common, width) }, common.theory);
}

BeamSection ceramicSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    return sectionOf (layersOf (common, width, ceramic), common.theory);
}

BeamSection looseSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto whole = ceramicSection (common, width, ceramic);
    auto section = sectionOf (layersOf (common, width, ceramic, false), common.theory);
    const auto layer = ceramicLayer (common, ceramic, 1);
    const auto count = ceramic.mounting == CeramicMounting::oneSide ? 1 : 2;
    section.massPerLength = whole.massPerLength;
    section.rotaryInertia = whole.rotaryInertia;
    section.bendingStiffness += count * layer.stretching() * layer.thickness * layer.thickness / 12;
    section.shearStiffness += count * shearFactor * layer.shearModulus * layer.width * layer.thickness;
    return section;
}

double bondLength (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto compliance = bondCompliance (ceramic, common.theory) / ceramic.sizeY;
    const auto yields = 1 / (ceramic.material.youngsModulus * ceramic.sizeY * ceramic.thickness)
                        + (ceramic.mounting == CeramicMounting::oneSide
                               ? 1 / (common.material.youngsModulus1 * width * common.thickness)
                               : 0.0);
    const auto stiffening = ceramicSection (common, width, ceramic).bendingStiffness
                            / looseSection (common, width, ceramic).bendingStiffness;
    const auto length = std::sqrt (compliance / yields / stiffening);

    if (! (length > 0))
        return 0;

    return length * std::tanh (ceramic.sizeX / (2 * length));
}

double momentPerVolt (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto& material = ceramic.material;
    const auto fieldTimesThickness =
        material.fibres ? ceramic.thickness / material.fibres->electrodeDistance : 1.0; // Per volt.
    const auto forcePerVolt =
        ceramic.polarity * material.d31 * material.youngsModulus * ceramic.sizeY * fieldTimesThickness;
    const auto distance = midPlaneDistance (common, ceramic);

    if (ceramic.mounting == CeramicMounting::oneSide)
        return forcePerVolt * (distance - neutralAxis (layersOf (common, width, ceramic)));

    const auto ceramicsAtFullVoltage = ceramic.wiring == CeramicWiring::parallel ? 2.0 : 1.0;
    return ceramicsAtFullVoltage * forcePerVolt * distance;
}
} // namespace antinode
