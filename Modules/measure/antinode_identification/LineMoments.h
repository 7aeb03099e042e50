#pragma once

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
} // namespace antinode
