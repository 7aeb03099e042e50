#pragma once

#include <antinode_model/Surface.h>

#include <vector>

namespace antinode
{
/** Fields on a plate's points at other places of it.
    @param fields  N_p x N
    @param places  M x 2: x and y, m
    @return        M x N; not a number beyond the boundary of a surface
    [worker] Docs/Theory.md, section 1.5. */
Eigen::MatrixXd fieldsAt (const Surface&, const Eigen::MatrixXd& fields, const Eigen::MatrixX2d& places);

/** Fields on a plate's points as maps of square cells, a row for each y from below: at most so many cells along the
   longer side, and no more than 64 where the points lie on no grid, because there each cell has a spline of its own.
    Beyond the boundary of a surface a map has what is nearest: it is to be clipped there.
    @param fields  N_p x N
    @return        N maps
    [worker] Docs/Theory.md, section 1.5. */
std::vector<Eigen::MatrixXd> fieldMaps (const Surface&, const Eigen::MatrixXd& fields, int maximumCells);
} // namespace antinode
