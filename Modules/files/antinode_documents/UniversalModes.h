#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_responses/UniversalFile.h>

#include <vector>

namespace antinode
{
/** The modes of a model as universal data sets, as modal analysis programs read them: 151 header, 164 units (SI), 15
   nodes, 82 trace lines, and a 55 a mode with its frequency, damping ratio and mass-normalised shape.

    Nodes and modes are numbered from 1, as the format asks. What a mode gives for a volt has no place in it. There are
   no dates. [worker] Docs/FileFormats.md. */
std::vector<UniversalSet> modeSets (const ModalModel&);

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
