#include "CeramicBond.h"

#include "BendingProblem.h"

#include <Eigen/LU>

#include <cmath>

namespace antinode
{
namespace
{
/** A layer's share in a shear that is 1 at the bond and 0 at the free face: integral of its square over G. */
struct ShearedLayer
{
    double thickness = 0, shearModulus = 0, membrane = 0; ///< m, Pa, N/m
};

std::vector<ShearedLayer> shearedLayers (const CeramicDescription& ceramic, bool withCeramic)
{
    std::vector<ShearedLayer> layers;

    if (ceramic.carrier)
        layers.push_back ({ ceramic.carrier->thickness, ceramic.carrier->material.shearModulus,
                            ceramic.carrier->thickness * ceramic.carrier->material.youngsModulus1 });

    if (withCeramic)
    {
        const auto& material = ceramic.material;
        layers.push_back ({ ceramic.thickness, material.shearModulus(), ceramic.thickness * material.youngsModulus });
    }

    return layers;
}

/** Of what is glued on: each layer takes its share of the stress that comes through the bond. */
double complianceOf (const std::vector<ShearedLayer>& layers)
{
    double whole = 0, taken = 0, compliance = 0;

    for (const auto& layer : layers)
        whole += layer.membrane;

    for (const auto& layer : layers)
    {
        const auto below = 1 - taken / whole, above = 1 - (taken + layer.membrane) / whole;
        compliance += layer.thickness / (3 * layer.shearModulus) * (below * below + below * above + above * above);
        taken += layer.membrane;
    }

    return compliance;
}

Eigen::Matrix3d turned (const Eigen::Matrix3d& stiffness, double angle)
{
    return turnedSection ({ stiffness }, angle).stiffness;
}

/** Along the ceramic's sides, N/m. */
Eigen::Matrix3d membraneOf (const std::vector<SectionLayer>& layers)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();

    for (const auto& layer : layers)
        if (! layer.softShearModulus)
            sum += layer.thickness * layer.stiffness.real();

    return sum;
}

void place (BondedPart& part, const CeramicDescription& ceramic, double angle)
{
    part.centre = ceramic.centre();
    part.angle = angle;
    part.isRound = ceramic.shape != CeramicShape::rectangle;
    part.half = part.isRound ? Eigen::Vector2d (ceramic.sizeX / 2, ceramic.innerDiameter / 2)
                             : Eigen::Vector2d (ceramic.sizeX / 2, ceramic.sizeY / 2);
}

/** About the neutral plane of bending along x, kg. */
double rotaryInertia (const std::vector<SectionLayer>& layers)
{
    double height = 0, stiffness = 0, moment = 0;

    for (const auto& layer : layers)
    {
        const auto membrane = layer.softShearModulus ? 0.0 : layer.thickness * layer.stiffness (0, 0).real();
        stiffness += membrane;
        moment += membrane * (height + layer.thickness / 2);
        height += layer.thickness;
    }

    double inertia = 0;
    height = -moment / stiffness;

    for (const auto& layer : layers)
    {
        const auto middle = height + layer.thickness / 2;
        inertia += layer.density * layer.thickness * (middle * middle + layer.thickness * layer.thickness / 12);
        height += layer.thickness;
    }

    return inertia;
}
} // namespace

double bondCompliance (const CeramicDescription& ceramic, BendingTheory theory, bool withCeramic)
{
    const auto glue = ceramic.glue ? ceramic.glue->thickness / ceramic.glue->material.shearModulus : 0.0;
    return glue + (theory == BendingTheory::thick ? complianceOf (shearedLayers (ceramic, withCeramic)) : 0.0);
}

double yieldingFactor (double stiffening)
{
    const auto more = stiffening - 1;
    return more > 0 ? more / (std::sqrt (stiffening) * std::log1p (more)) : 1;
}

std::optional<CeramicBond> ceramicBond (const StructureCommon& common, const CeramicDescription& ceramic, double angle,
                                        bool withCeramic)
{
    const auto compliance = bondCompliance (ceramic, common.theory, withCeramic);

    if (! (compliance > 0))
        return {};

    const auto whole = sectionWith (common, ceramic, angle, { withCeramic, true });
    CeramicBond bond { sectionWith (common, ceramic, angle, { withCeramic, false }), {} };
    auto& part = bond.part;
    part.stiffness = (whole.stiffness - bond.loose.stiffness).real();
    part.curvaturePerVolt = part.stiffness.inverse() * (whole.momentPerVolt - bond.loose.momentPerVolt).real();
    place (part, ceramic, angle);

    const Eigen::Matrix3d stiffening =
        turned (whole.stiffness.real(), -angle).cwiseQuotient (turned (bond.loose.stiffness.real(), -angle));
    const auto glued = membraneOf (gluedLayers (ceramic, withCeramic));
    const auto plate = turned (membraneOf (plateLayers (common)), -angle);

    for (Eigen::Index i = 0; i < 2; ++i)
    {
        const auto yields = ceramic.mounting == CeramicMounting::oneSide ? 1 / plate (i, i) : 0.0;
        part.lengths[i] = std::sqrt (compliance / (1 / glued (i, i) + yields)) * yieldingFactor (stiffening (i, i));
        part.shearLengths[i] = part.lengths[i] * std::sqrt (glued (2, 2) / glued (i, i));
    }

    return bond;
}

double addedRotaryInertia (const StructureCommon& common, const CeramicDescription& ceramic, bool withCeramic)
{
    if (common.theory != BendingTheory::thick)
        return 0;

    return rotaryInertia (stackLayers (common, ceramic, 0, { withCeramic, true }))
           - rotaryInertia (plateLayers (common));
}
} // namespace antinode
