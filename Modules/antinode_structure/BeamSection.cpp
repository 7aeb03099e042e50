#include "BeamSection.h"

#include "CeramicBond.h"

#include <cmath>

namespace antinode
{
namespace
{
/** Sums over layers about the middle of the substrate. */
struct LayerSums
{
    double mass = 0, stretching = 0, coupling = 0, bending = 0;

    void add (double youngsModulus, double density, double width, double thickness, double middle)
    {
        const auto area = width * thickness;
        mass += density * area;
        stretching += youngsModulus * area;
        coupling += youngsModulus * area * middle;
        bending += youngsModulus * area * (middle * middle + thickness * thickness / 12);
    }

    /** How far a ceramic on one side moves the neutral axis out of the substrate's mid-plane, z_n. */
    double neutralAxis() const { return coupling / stretching; }
};

double glueThickness (const CeramicDescription& ceramic)
{
    return ceramic.glue ? ceramic.glue->thickness : 0;
}

/** From the substrate's mid-plane to that of a ceramic, d. */
double midPlaneDistance (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return (common.thickness + ceramic.thickness) / 2 + glueThickness (ceramic);
}

LayerSums sumsOf (const StructureCommon& common, double width, const CeramicDescription& ceramic,
                  bool withCeramics = true)
{
    LayerSums sums;
    sums.add (common.material.youngsModulus1, common.material.density, width, common.thickness, 0);

    for (const auto side : { 1, -1 })
    {
        if (side < 0 && ceramic.mounting == CeramicMounting::oneSide)
            break;

        if (withCeramics)
            sums.add (ceramic.material.youngsModulus, ceramic.material.density, ceramic.sizeY, ceramic.thickness,
                      side * midPlaneDistance (common, ceramic));

        if (ceramic.glue)
            sums.add (ceramic.glue->material.youngsModulus1, ceramic.glue->material.density, ceramic.sizeY,
                      ceramic.glue->thickness, side * (common.thickness + ceramic.glue->thickness) / 2);
    }

    return sums;
}

BeamSection aboutNeutralAxis (const LayerSums& sums)
{
    return { sums.mass, sums.bending - sums.coupling * sums.neutralAxis(), sums.stretching };
}
} // namespace

BeamSection bareSection (const StructureCommon& common, double width)
{
    LayerSums sums;
    sums.add (common.material.youngsModulus1, common.material.density, width, common.thickness, 0);
    return aboutNeutralAxis (sums);
}

BeamSection ceramicSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    return aboutNeutralAxis (sumsOf (common, width, ceramic));
}

BeamSection looseSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto whole = sumsOf (common, width, ceramic);
    auto section = aboutNeutralAxis (sumsOf (common, width, ceramic, false));
    const auto count = ceramic.mounting == CeramicMounting::oneSide ? 1 : 2;
    section.massPerLength = whole.mass;
    section.bendingStiffness +=
        count * ceramic.material.youngsModulus * ceramic.sizeY * std::pow (ceramic.thickness, 3) / 12;
    return section;
}

double bondLength (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    if (! ceramic.glue)
        return 0;

    const auto compliance = bondCompliance (ceramic, PlateTheory::mindlin) / ceramic.sizeY;
    const auto yields = 1 / (ceramic.material.youngsModulus * ceramic.sizeY * ceramic.thickness)
                        + (ceramic.mounting == CeramicMounting::oneSide
                               ? 1 / (common.material.youngsModulus1 * width * common.thickness)
                               : 0.0);
    const auto stiffening = ceramicSection (common, width, ceramic).bendingStiffness
                            / looseSection (common, width, ceramic).bendingStiffness;
    const auto length = std::sqrt (compliance / yields / stiffening);
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
        return forcePerVolt * (distance - sumsOf (common, width, ceramic).neutralAxis());

    const auto ceramicsAtFullVoltage = ceramic.wiring == CeramicWiring::parallel ? 2.0 : 1.0;
    return ceramicsAtFullVoltage * forcePerVolt * distance;
}
} // namespace antinode
