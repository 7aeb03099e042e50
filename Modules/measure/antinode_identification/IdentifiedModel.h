#pragma once

#include "IdentifiedModes.h"

#include <antinode_model/ModalModel.h>
#include <antinode_outline/Outline.h>

namespace antinode
{
/** Properties of the surface that measured responses do not contain. */
struct MappedSurface
{
    std::string name;
    Eigen::VectorXd
        masses; ///< N_p: kg each point stands for; empty: from the shapes' orthogonality, Docs/Theory.md, section 8.6.
    std::optional<SurfaceBoundary> boundary; ///< Where the surface ends; none: at the rectangle around the points.
    std::optional<bool> coversWholeBody; ///< Whether the points cover all that moves; where not said, it is decided.
    std::vector<Ceramic> ceramics;       ///< N_b or empty: names and limits.
    double voltageLimit = 150;           ///< V, of all ceramics where none are given.
    double fullScaleVoltage = 150;       ///< V
};

/** A device as its identified modes: what focus designs on.

    Points are areas of their own (on a line the half distances between neighbours, in the plane Voronoi cells within
   the boundary); masses are as given, or proportional to them. Points without data are left out. Where all y are equal
   it is a line.
    @throws InputError  when references are forces, ceramics or masses are not one per reference or point, two points
   coincide, or one lies outside the boundary [worker] Docs/Theory.md, section 8.6. */
ModalModel toModalModel (const IdentifiedModes&, const MappedSurface&);

/** The share of a line that each point stands for: half the distances to its neighbours; 1 of a point that
    is alone. @param x N, ascending, m @return N, m [worker] */
Eigen::VectorXd lineCells (const Eigen::VectorXd& x);

/** The area of each point's Voronoi cell, cut off at the rectangle around all points.
    @param points  N x 2, m @return N, m^2; 0 is possible for points on the boundary of a few points only
    [worker] */
Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points);

/** The same, cut off at an outline and its holes; arcs count as sixteen chords each. [worker] */
Eigen::VectorXd voronoiCells (const Eigen::MatrixX2d& points, const Outline&);
} // namespace antinode
