#include "ModalProducts.h"

#include "LineSegment.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>

namespace antinode
{
namespace
{
Eigen::MatrixXd transposedProduct (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.cols(), b.cols());
    addTransposedLeft (result, 1, a, b);
    return result;
}

/** Re <functions, something> for near and far functions, added to the rows of a result. */
void addProducts (Eigen::MatrixXd& to, const LineSegment& segment, const Eigen::MatrixXd& real,
                  const Eigen::MatrixXd& imaginary)
{
    Eigen::MatrixXd near = transposedProduct (segment.nearReal, real);
    addTransposedLeft (near, 1, segment.nearImaginary, imaginary);

    for (std::size_t n = 0; n < segment.near.size(); ++n)
        to.row (segment.near[n]) += near.row (static_cast<Eigen::Index> (n));

    if (segment.far.empty())
        return;

    Eigen::MatrixXd far = transposedProduct (segment.farReal, transposedProduct (segment.interpolation, real));
    addTransposedLeft (far, 1, segment.farImaginary, transposedProduct (segment.interpolation, imaginary));

    for (std::size_t n = 0; n < segment.far.size(); ++n)
        to.row (segment.far[n]) += far.row (static_cast<Eigen::Index> (n));
}

void addSegmentGram (Eigen::MatrixXd& gram, const LineSegment& segment)
{
    const auto nearCount = static_cast<Eigen::Index> (segment.near.size());
    Eigen::MatrixXd withNear = Eigen::MatrixXd::Zero (gram.rows(), nearCount);
    addProducts (withNear, segment, segment.nearReal, segment.nearImaginary);

    for (Eigen::Index n = 0; n < nearCount; ++n)
    {
        const auto column = segment.near[static_cast<std::size_t> (n)];
        gram.col (column) += withNear.col (n);

        for (const auto far : segment.far)
            gram (column, far) += withNear (far, n);
    }

    if (segment.far.empty())
        return;

    const auto inner = transposedProduct (segment.interpolation, segment.interpolation);
    Eigen::MatrixXd between = transposedProduct (segment.farReal, transposedProduct (inner, segment.farReal));
    addTransposedLeft (between, 1, segment.farImaginary, transposedProduct (inner, segment.farImaginary));

    for (std::size_t m = 0; m < segment.far.size(); ++m)
        for (std::size_t n = 0; n < segment.far.size(); ++n)
            gram (segment.far[n], segment.far[m]) +=
                between (static_cast<Eigen::Index> (n), static_cast<Eigen::Index> (m));
}
} // namespace

ModalProducts modalProducts (const ModalBasis& basis, const PreparedResponses& data, double delay)
{
    ModalProducts result { Eigen::MatrixXd::Zero (basis.size(), basis.size()),
                           Eigen::MatrixXd::Zero (basis.size(), data.columns()),
                           Eigen::VectorXd::Zero (data.columns()) };

    for (Eigen::Index first = 0; first < data.lines(); first += linesOfSegment)
    {
        const auto count = std::min (linesOfSegment, data.lines() - first);
        const Eigen::VectorXd roots = data.lineWeights.segment (first, count).cwiseSqrt();
        const auto segment = lineSegment (basis, data.omega.segment (first, count), roots);
        const auto values = dataBlock (data, first, roots.asDiagonal() * advances (data, first, count, delay));
        addSegmentGram (result.gram, segment);
        addProducts (result.data, segment, values.real, values.imaginary);
        result.energies += (values.real.colwise().squaredNorm() + values.imaginary.colwise().squaredNorm()).transpose();
    }

    return result;
}
} // namespace antinode
