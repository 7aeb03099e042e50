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

/** Inner products of all functions with each other and with the data.
    @param delay  s, is taken out of the data
    [worker] Docs/Theory.md, section 8.4. */
ModalProducts modalProducts (const ModalBasis&, const PreparedResponses&, double delay);
} // namespace antinode
