#pragma once

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** Mode shapes on points that a viewer can show. N points, N_m modes. */
struct ShapeMesh
{
    Eigen::MatrixX2d points; ///< N x 2: x and y, m.
    Eigen::MatrixXd shapes;  ///< N x N_c: normal to the surface, kg^-1/2.
    std::vector<std::vector<Eigen::Index>>
        traces; ///< Lines of neighbouring points, from 0; each has two points or more.
};

/** The shapes of a model on the points of its surface; those of a computed plate on an even grid from edge to edge,
   with about eight points a wavelength of the most rippled mode and at most 4000. Traces join the points that share an
   x or a y. [worker] */
ShapeMesh shapeMesh (const ModalModel&);
} // namespace antinode
