#pragma once

#include "BondedPart.h"

#include <antinode_outline/Outline.h>

#include <optional>
#include <vector>

namespace antinode
{
/** A plate's section in bending: moments (M11, M22, M12) = stiffness (w,11 w,22 2 w,12). */
struct BendingSection
{
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero(); ///< Symmetric, N m.
    double massPerArea = 0;                              ///< kg/m^2
    double rotaryInertia = 0; ///< Per area, kg: its energy is half of it times the slope's square.
};

/** The same section with its material turned counter-clockwise by an angle. [any] Jones, Mechanics of Composite
   Materials, section 2.6. */
BendingSection turnedSection (const BendingSection&, double angle);

/** How an edge is held. A free one: not at all. */
struct EdgeSupport
{
    bool holdsDisplacement = false, holdsSlope = false; ///< The slope is that across the edge.
    double translation = 0;                             ///< Stiffness per length against displacement, N/m^2.
    double rotation = 0;                                ///< Against the slope across the edge, N.
};

/** The straight line or circle along which the curvature jumps, as a function of the place that vanishes there: a
   quadratic polynomial, positive inside. */
struct KinkFunction
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero(); ///< At the centre.
    double value = 0;                                   ///< At the centre.
    double curvature = 0;                               ///< Its second derivative, the same in every direction.
    int edge = 0;                                       ///< Of the patch's outline, whose pieces lie on it.
    double width = 1;                                   ///< Half of the width of the patch.

    double operator() (const Eigen::Vector2d& place) const
    {
        const Eigen::Vector2d offset = place - centre;
        return value + gradient.dot (offset) + curvature / 2 * offset.squaredNorm();
    }

    /** Whether it is a line of equal x or y, on which splines can be made to bend. */
    bool isAlongAxis() const { return curvature == 0 && (gradient.x() == 0 || gradient.y() == 0); }
};

/** A part of the plate with something on it; its outline lies within that of the plate. */
struct BendingPatch
{
    Outline outline;
    BendingSection added;                             ///< To the plate's own.
    double foundation = 0;                            ///< Winkler's, N/m^3.
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< Per volt, N/V: its load is moment . (w,11 w,22 2 w,12).
    std::vector<KinkFunction> kinks;                  ///< Where its edges bend the plate; none: none are resolved.
    std::optional<BondedPart> bonded {};              ///< What adds to stiffness and moment, less towards its edges.

    // At a place on it, with what is bonded. [any]

    Eigen::Matrix3d stiffnessAt (const Eigen::Vector2d& place) const;
    Eigen::Vector3d momentAt (const Eigen::Vector2d& place) const;
    bool hasMoment() const { return moment.any() || (bonded && bonded->curvaturePerVolt.any()); }
};

/** A spring to ground and a mass at one place. */
struct PointAttachment
{
    Eigen::Vector2d place;
    double stiffness = 0; ///< N/m
    double mass = 0;      ///< kg
};

/** A thin plate of any outline in bending, in any consistent units. Docs/Theory.md, section 1.13. */
struct BendingProblem
{
    Outline outline;
    std::vector<EdgeSupport> edges; ///< By the numbers of the outline's edges.
    BendingSection section;
    double foundation = 0; ///< Winkler's, under the whole plate, N/m^3.
    std::vector<BendingPatch> patches;
    std::vector<PointAttachment> points;
};

/** D / (m L^4) of the bare plate, L the longer side of its extent, 1/s^2: what eigenvalues are measured by. [any] */
double eigenvalueUnit (const BendingProblem&);
} // namespace antinode
