#include "LineMoments.h"

#include "ChebyshevNodes.h"

#include <antinode_numerics/DenseKernels.h>

#include <cmath>

namespace antinode
{
namespace
{
constexpr Eigen::Index linesOfSmallest = 2 * fewLines;

Eigen::MatrixXd transposedProduct (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.cols(), b.cols());
    addTransposedLeft (result, 1, a, b);
    return result;
}

LineSpan emptySpan (const PreparedResponses& data, Eigen::Index first, Eigen::Index count)
{
    LineSpan span;
    span.first = first;
    span.count = count;
    const auto lowest = data.omega[first], highest = data.omega[first + count - 1];
    span.centre = (lowest + highest) / 2;
    span.halfWidth = (highest - lowest) / 2;

    if (count >= fewLines)
        span.nodes = chebyshevNodes (span.centre, span.halfWidth);

    return span;
}

void sumLines (LineSpan& span, const PreparedResponses& data, LineMoments& all)
{
    const Eigen::VectorXd roots = data.lineWeights.segment (span.first, span.count).cwiseSqrt();
    const auto values =
        dataBlock (data, span.first, roots.asDiagonal() * advances (data, span.first, span.count, all.delay));
    all.energies += (values.real.colwise().squaredNorm() + values.imaginary.colwise().squaredNorm()).transpose();

    if (span.nodes.size() == 0)
        return;

    const Eigen::MatrixXd polynomials =
        roots.asDiagonal() * interpolation (data.omega.segment (span.first, span.count), span.nodes);
    span.overlaps = transposedProduct (polynomials, polynomials);
    span.dataReal = transposedProduct (polynomials, values.real);
    span.dataImaginary = transposedProduct (polynomials, values.imaginary);
}

/** A polynomial on the whole is one on either half. */
void addHalf (LineSpan& whole, const LineSpan& half)
{
    const auto toHalf = interpolation (half.nodes, whole.nodes);
    whole.overlaps += toHalf.transpose() * half.overlaps * toHalf;
    addTransposedLeft (whole.dataReal, 1, toHalf, half.dataReal);
    addTransposedLeft (whole.dataImaginary, 1, toHalf, half.dataImaginary);
}

void fillSpan (LineMoments& all, Eigen::Index index, const PreparedResponses& data)
{
    const auto at = [&all] (Eigen::Index n) -> LineSpan& { return all.spans[static_cast<std::size_t> (n)]; };
    const auto first = at (index).first, count = at (index).count;

    if (count <= linesOfSmallest)
        return sumLines (at (index), data, all);

    const auto lower = count / 2, halves = static_cast<Eigen::Index> (all.spans.size());
    at (index).halves = halves;
    all.spans.push_back (emptySpan (data, first, lower));
    all.spans.push_back (emptySpan (data, first + lower, count - lower));
    at (index).overlaps = Eigen::MatrixXd::Zero (smoothNodes, smoothNodes);
    at (index).dataReal = at (index).dataImaginary = Eigen::MatrixXd::Zero (smoothNodes, data.columns());

    for (const auto half : { halves, halves + 1 })
    {
        fillSpan (all, half, data);
        addHalf (at (index), at (half));
    }
}
} // namespace

LineMoments lineMoments (const PreparedResponses& data, double delay)
{
    LineMoments result { delay, { emptySpan (data, 0, data.lines()) }, Eigen::VectorXd::Zero (data.columns()) };
    fillSpan (result, 0, data);
    return result;
}

bool isNear (const LineMoments& moments, double delay)
{
    constexpr double smooth = 1; // rad
    return std::abs (delay - moments.delay) * moments.spans.front().halfWidth <= smooth;
}
} // namespace antinode
