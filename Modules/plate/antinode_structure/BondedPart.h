#pragma once

#include <Eigen/Core>

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
} // namespace antinode
