#pragma once

#include "ElementResults.h"

namespace antinode
{
/** Which side of a body is touched: its highest plane along an axis, or against it. */
struct SideChoice
{
    int axis = 2;        ///< 0 x, 1 y, 2 z: normal to the surface.
    bool isTop = true;   ///< False: the lowest plane.
    double flatness = 0; ///< m that nodes may lie behind the plane; 0: a thousandth of the surface's extent.
    int maximumPoints = 2000;
};

/** A ceramic as its forces show it, in the plane of the surface. */
struct LoadedArea
{
    double xMinimum = 0, xMaximum = 0, yMinimum = 0, yMaximum = 0; ///< m
};

/** The points of a finite-element body that are touched. N_p points. */
struct TouchedSurface
{
    std::vector<Eigen::Index> nodes; ///< N_p
    Eigen::MatrixX2d points;         ///< N_p x 2, m: the axes behind the normal one in the order x, y, z, x.
    std::vector<LoadedArea> ceramics;
    Eigen::Index meshNodes = 0; ///< Of the plane, before they were thinned.
    Eigen::Index lower = 0;     ///< Nodes that are the highest of their place and yet behind the plane: left out.
};

/** The flat surface of a body without its ceramics, whose materials have all nodes with reaction forces. Of nodes above
   each other the outermost counts; more points than wanted are thinned evenly.
    @throws InputError  where fewer than 3 points are left
    [worker] Docs/Theory.md, section 1.14. */
TouchedSurface findTouchedSurface (const ElementResults&, const SideChoice&);
} // namespace antinode
