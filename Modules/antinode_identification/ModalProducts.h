#pragma once

#include "ModalFunctions.h"
#include "PreparedResponses.h"

namespace antinode
{
/** All that a least-squares fit of modes needs to know of the data: weighted inner products Re <f, g> over the lines.
    N functions (see ModalBasis), C columns of data. Column weights are not in them, line weights are. */
struct ModalProducts
{
    Eigen::MatrixXd gram;     ///< N x N
    Eigen::MatrixXd data;     ///< N x C
    Eigen::VectorXd energies; ///< C: <data, data>.
};

/** Inner products of all functions with each other and with the data. On a segment of lines, functions of modes far from it are smooth:
    they are interpolated from 16 Chebyshev nodes, to 1e-12, so that the work grows with the modes near a line, not with all.
    @param delay  s, is taken out of the data
    [worker] Docs/Theory.md, section 8.4. */
ModalProducts modalProducts (const ModalBasis&, const PreparedResponses&, double delay);
} // namespace antinode
