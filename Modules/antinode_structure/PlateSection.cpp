#include "PlateSection.h"

#include <Eigen/LU>

namespace antinode
{
namespace
{
/** Plane-stress stiffness: the part that couples the strains along x and y, and shear. */
struct ReducedStiffness
{
    Eigen::Matrix2d normal;
    double shear = 0;
};

ReducedStiffness reduced (const ElasticMaterial& material)
{
    const auto poissonRatio21 = material.poissonRatio12 * material.youngsModulus2 / material.youngsModulus1;
    const auto divisor = 1 - material.poissonRatio12 * poissonRatio21;
    const auto coupling = material.poissonRatio12 * material.youngsModulus2;
    ReducedStiffness stiffness;
    stiffness.normal << material.youngsModulus1, coupling, coupling, material.youngsModulus2;
    stiffness.normal /= divisor;
    stiffness.shear = material.shearModulus;
    return stiffness;
}

ReducedStiffness reduced (const PiezoelectricMaterial& material)
{
    const auto shearModulus = material.youngsModulus / (2 * (1 + material.poissonRatio));
    return reduced (ElasticMaterial { material.youngsModulus, material.youngsModulus, shearModulus,
                                      material.poissonRatio, material.density });
}

/** Stretching A, coupling B and bending D of layers about the substrate's mid-plane. */
struct Laminate
{
    ReducedStiffness stretching, coupling, bending;

    void add (const ReducedStiffness& stiffness, double middle, double thickness)
    {
        addTo (stretching, stiffness, thickness);
        addTo (coupling, stiffness, thickness * middle);
        addTo (bending, stiffness, thickness * (middle * middle + thickness * thickness / 12));
    }

    static Laminate empty()
    {
        const ReducedStiffness zero { Eigen::Matrix2d::Zero(), 0 };
        return { zero, zero, zero };
    }

private:
    static void addTo (ReducedStiffness& sum, const ReducedStiffness& stiffness, double factor)
    {
        sum.normal += factor * stiffness.normal;
        sum.shear += factor * stiffness.shear;
    }
};

PlateSection makeSection (const ReducedStiffness& bending, double massPerArea)
{
    return { massPerArea, bending.normal (0, 0), bending.normal (1, 1), bending.normal (0, 1), bending.shear, 0, 0 };
}
} // namespace

PlateSection bareSection (const StructureCommon& common)
{
    auto laminate = Laminate::empty();
    laminate.add (reduced (common.material), 0, common.thickness);
    return makeSection (laminate.bending, common.material.density * common.thickness);
}

PlateSection ceramicSection (const StructureCommon& common, const CeramicDescription& ceramic)
{
    const auto isPair = ceramic.mounting == CeramicMounting::bothSides;
    const auto distance = (common.thickness + ceramic.thickness) / 2;
    const auto stiffness = reduced (ceramic.material);
    auto laminate = Laminate::empty();
    laminate.add (reduced (common.material), 0, common.thickness);
    laminate.add (stiffness, distance, ceramic.thickness);

    if (isPair)
        laminate.add (stiffness, -distance, ceramic.thickness);

    const auto& [stretching, coupling, bending] = laminate;
    const Eigen::Matrix2d shift = coupling.normal * stretching.normal.inverse();
    const ReducedStiffness freeInPlane { bending.normal - shift * coupling.normal,
                                         bending.shear - coupling.shear * coupling.shear / stretching.shear };
    const auto massPerArea =
        common.material.density * common.thickness + (isPair ? 2 : 1) * ceramic.material.density * ceramic.thickness;
    auto section = makeSection (freeInPlane, massPerArea);

    // ebar31 = d31 / (s11 + s12), the force per length and volt of one ceramic.
    const auto forcePerVolt =
        ceramic.polarity * ceramic.material.d31 * ceramic.material.youngsModulus / (1 - ceramic.material.poissonRatio);
    const auto ceramicsAtFullVoltage = isPair && ceramic.wiring == CeramicWiring::parallel ? 2 : 1;
    Eigen::Vector2d arm = Eigen::Vector2d::Constant (ceramicsAtFullVoltage * distance);

    if (! isPair)
        arm -= shift * Eigen::Vector2d::Ones();

    section.momentX = forcePerVolt * arm[0];
    section.momentY = forcePerVolt * arm[1];
    return section;
}
} // namespace antinode
