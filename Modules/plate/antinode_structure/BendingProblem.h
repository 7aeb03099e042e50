#pragma once

#include <Eigen/Core>
#include <antinode_outline/Outline.h>

#include <optional>
#include <vector>

namespace antinode
{
/** How much of its full stress a bond that shears hands over to what is glued between two edges.
    @param offset  from the middle between the edges @param half  of their distance
    @param length  over which it builds up; 0: at once. All in one unit.
    @return        0 at the edges, 1 far within
    [any] Docs/Theory.md, section 1.16. */
double bondedShare (double offset, double half, double length);

/** The same on a disc, of its radius. [any] Docs/Theory.md, section 1.16. */
double bondedShareOfDisc (double distance, double radius, double length);

/** What of a glued patch's stiffness and moment builds up from its edges, since the bond shears. Stress along an axis
    needs a length from the edges across it; what one direction hands to the other by Poisson's ratio needs both.
    Stiffness is that of BendingSection, along the plate's axes. */
struct BondedPart
{
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();        ///< Of a patch without edges, N m.
    Eigen::Vector3d curvaturePerVolt = Eigen::Vector3d::Zero(); ///< (w,11 w,22 2 w,12) without load, 1/(m V).
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();           ///< m
    Eigen::Vector2d half = Eigen::Vector2d::Zero(); ///< Of a rectangle's sides, m. Round: radius and inner one.
    double angle = 0;                               ///< Of a rectangle, rad counter-clockwise.
    bool isRound = false;
    Eigen::Vector2d lengths = Eigen::Vector2d::Zero();      ///< Along the sides, m. Round: the first.
    Eigen::Vector2d shearLengths = Eigen::Vector2d::Zero(); ///< The same of shear within the plane.

    /** bondedShare at a place between the edges that cross one side of a rectangle along the axes.
        @param side  0: along x, 1: along y @param builtUpOver  lengths or shearLengths [any] */
    double shareAlong (Eigen::Index side, double place, const Eigen::Vector2d& builtUpOver) const
    {
        return bondedShare (place - centre[side], half[side], builtUpOver[side]);
    }

    /** The stiffness at a place on the patch. [any] */
    Eigen::Matrix3d stiffnessAt (const Eigen::Vector2d& place) const;

    /** The moment per volt there, N/V. [any] */
    Eigen::Vector3d momentAt (const Eigen::Vector2d& place) const { return stiffnessAt (place) * curvaturePerVolt; }
};

/** In units in which a length and a stiffness are 1. Moments per volt stay as they are. [any] */
BondedPart scaledPart (BondedPart, double length, double stiffness);

/** A stiffness along two axes in parts, by what they need to build up. */
struct BondedStiffness
{
    double first = 0, second = 0;                       ///< Along one axis alone: by its own share.
    double bothFirst = 0, bothSecond = 0, coupling = 0; ///< By the product of both shares.
    double shear = 0;                                   ///< By that of the shares of shear.

    /** Of a stiffness along these axes, without coupling of stretch and shear. [any] */
    static BondedStiffness of (const Eigen::Matrix3d& stiffness);
};

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

// Patches of the usual shapes, with the kinks that their edges make, and nothing on them yet. Lengths in m, angles in
// rad counter-clockwise. [any] Docs/Theory.md, section 1.13.

BendingPatch rectanglePatch (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle);

BendingPatch discPatch (const Eigen::Vector2d& centre, double radius);

BendingPatch ringPatch (const Eigen::Vector2d& centre, double radius, double innerRadius);
} // namespace antinode
