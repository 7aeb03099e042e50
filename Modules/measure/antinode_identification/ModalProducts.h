#pragma once

#include "LineMoments.h"
#include "ModalFunctions.h"

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

/** Inner products of all functions with each other and with the data. Functions of a pole far from some lines are
    interpolated there, so that work grows with the poles near a line, not with all.
    @param moments  of these responses, near to the delay
    @param delay    s, is taken out of the data
    [worker] Docs/Theory.md, section 8.4. */
ModalProducts modalProducts (const ModalBasis&, const PreparedResponses&, const LineMoments& moments, double delay);

/** The same, once. [worker] */
ModalProducts modalProducts (const ModalBasis&, const PreparedResponses&, double delay);
} // namespace antinode
