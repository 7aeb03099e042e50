#pragma once

#include "ModalFunctions.h"
#include "PreparedResponses.h"

#include <vector>

namespace antinode
{
/** Neighbouring lines, and their weighted sums with the polynomials that interpolate smooth functions there. C columns
    of data. */
struct LineSpan
{
    Eigen::Index first = 0, count = 0; ///< Lines.
    Eigen::Index halves = 0;           ///< Index of the span of its lower half, that of the upper follows; 0: none.
    double centre = 0, halfWidth = 0;  ///< rad/s
    Eigen::VectorXd nodes;             ///< smoothNodes, rad/s; none where lines are too few.
    Eigen::MatrixXd overlaps;          ///< smoothNodes x smoothNodes: of the polynomials with each other.
    Eigen::MatrixXd dataReal, dataImaginary; ///< smoothNodes x C: of the polynomials with the data.
};

/** Responses as a fit needs them over and over, for one weighting of lines and columns: the whole range, its halves,
    their halves and so on. Functions are smooth where no pole is near; with them, data need not be looked at again. */
struct LineMoments
{
    double delay = 0;            ///< s, taken out of the data.
    std::vector<LineSpan> spans; ///< The whole range first; halves have no halves from 128 lines on.
    Eigen::VectorXd energies;    ///< C: <data, data>.
};

/** [worker] Docs/Theory.md, section 8.4. */
LineMoments lineMoments (const PreparedResponses&, double delay);

/** Whether a delay is so near to the one that was taken out that the difference is smooth on the whole range. [any] */
bool isNear (const LineMoments&, double delay);

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
