#include "BeamSection.h"

namespace antinode
{
namespace
{
/** From the substrate's mid-plane to that of a ceramic, d. */
double midPlaneDistance (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return (common.thickness + ceramic.thickness) / 2;
}

/** EA of one ceramic. */
double ceramicAxialStiffness (const CeramicDescription& ceramic)
{
    return ceramic.material.youngsModulus * ceramic.sizeY * ceramic.thickness;
}

/** How far a ceramic on one side moves the neutral axis out of the substrate's mid-plane, z_n. */
double neutralAxisShift (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto ceramicStiffness = ceramicAxialStiffness (ceramic);
    const auto wholeStiffness = bareSection (common, width).axialStiffness + ceramicStiffness;
    return ceramicStiffness * midPlaneDistance (common, ceramic) / wholeStiffness;
}
} // namespace

BeamSection bareSection (const StructureCommon& common, double width)
{
    const auto area = width * common.thickness;
    const auto axialStiffness = common.material.youngsModulus1 * area;
    return { common.material.density * area, axialStiffness * common.thickness * common.thickness / 12,
             axialStiffness };
}

BeamSection ceramicSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto ceramicStiffness = ceramicAxialStiffness (ceramic);
    const auto ceramicMass = ceramic.material.density * ceramic.sizeY * ceramic.thickness;
    const auto ownBending = ceramic.thickness * ceramic.thickness / 12;
    const auto distance = midPlaneDistance (common, ceramic);
    auto section = bareSection (common, width);

    if (ceramic.mounting == CeramicMounting::bothSides)
    {
        section.massPerLength += 2 * ceramicMass;
        section.bendingStiffness += 2 * ceramicStiffness * (ownBending + distance * distance);
        section.axialStiffness += 2 * ceramicStiffness;
        return section;
    }

    const auto shift = neutralAxisShift (common, width, ceramic);
    const auto arm = distance - shift;
    section.massPerLength += ceramicMass;
    section.bendingStiffness += section.axialStiffness * shift * shift + ceramicStiffness * (ownBending + arm * arm);
    section.axialStiffness += ceramicStiffness;
    return section;
}

double momentPerVolt (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto forcePerVolt = ceramic.polarity * ceramic.material.d31 * ceramic.material.youngsModulus * ceramic.sizeY;
    const auto distance = midPlaneDistance (common, ceramic);

    if (ceramic.mounting == CeramicMounting::oneSide)
        return forcePerVolt * (distance - neutralAxisShift (common, width, ceramic));

    const auto ceramicsAtFullVoltage = ceramic.wiring == CeramicWiring::parallel ? 2.0 : 1.0;
    return ceramicsAtFullVoltage * forcePerVolt * distance;
}
} // namespace antinode
