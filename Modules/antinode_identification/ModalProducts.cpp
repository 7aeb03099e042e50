#include "ModalProducts.h"

#include <antinode_model/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr Eigen::Index nodes = 16, linesOfSegment = 512;

/** Functions on the lines of one segment, times the roots of the line weights: columns of near ones, and what interpolates the far ones. */
struct Segment
{
    std::vector<Eigen::Index> near, far;     ///< Columns of the basis.
    Eigen::MatrixXd nearReal, nearImaginary; ///< Lines x near.
    Eigen::MatrixXd interpolation;           ///< Lines x nodes.
    Eigen::MatrixXd farReal, farImaginary;   ///< Nodes x far: values at the nodes.
};

Eigen::VectorXd chebyshevNodes (double centre, double halfWidth)
{
    Eigen::VectorXd result (nodes);

    for (Eigen::Index j = 0; j < nodes; ++j)
        result[j] = centre + halfWidth * std::cos (std::numbers::pi * (static_cast<double> (j) + 0.5) / nodes);

    return result;
}

/** Lagrange polynomials through the nodes, in barycentric form. */
Eigen::MatrixXd lagrange (const Eigen::VectorXd& omega, const Eigen::VectorXd& at)
{
    Eigen::MatrixXd result (omega.size(), nodes);

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        for (Eigen::Index j = 0; j < nodes; ++j)
        {
            const auto sign = j % 2 == 0 ? 1.0 : -1.0;
            const auto weight = sign * std::sin (std::numbers::pi * (static_cast<double> (j) + 0.5) / nodes);
            const auto distance = omega[f] - at[j];
            result (f, j) = weight / (distance == 0 ? 1e-300 : distance);
        }

        result.row (f) /= result.row (f).sum();
    }

    return result;
}

void appendColumns (std::vector<Eigen::Index>& list, Eigen::Index first, Eigen::Index count)
{
    for (Eigen::Index j = 0; j < count; ++j)
        list.push_back (first + j);
}

Segment makeSegment (const ModalBasis& basis, const Eigen::VectorXd& omega, const Eigen::VectorXd& roots)
{
    const auto centre = (omega[0] + omega[omega.size() - 1]) / 2, halfWidth = (omega[omega.size() - 1] - omega[0]) / 2;
    const auto nodesAt = chebyshevNodes (centre, halfWidth);
    std::vector<Eigen::Index> nearModes, farModes;
    Segment segment;

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        const auto isFar = omega.size() >= 4 * nodes && std::abs (basis.angularFrequencies[k] - centre) > 3 * halfWidth
                           && centre > 2 * halfWidth;
        (isFar ? farModes : nearModes).push_back (k);
        appendColumns (isFar ? segment.far : segment.near, functionsOfMode * k, functionsOfMode);
    }

    const auto powers = static_cast<Eigen::Index> (basis.powers.size());
    appendColumns (segment.near, functionsOfMode * basis.modes(), powers);
    Eigen::MatrixXcd near (omega.size(), static_cast<Eigen::Index> (segment.near.size()));
    Eigen::MatrixXcd far (nodes, static_cast<Eigen::Index> (segment.far.size()));

    for (std::size_t n = 0; n < nearModes.size(); ++n)
        near.middleCols (functionsOfMode * static_cast<Eigen::Index> (n), functionsOfMode) =
            functionsOf (basis, nearModes[n], omega);

    for (std::size_t n = 0; n < farModes.size(); ++n)
        far.middleCols (functionsOfMode * static_cast<Eigen::Index> (n), functionsOfMode) =
            functionsOf (basis, farModes[n], nodesAt);

    near.rightCols (powers) = powersOf (basis, omega);
    segment.nearReal = roots.asDiagonal() * near.real();
    segment.nearImaginary = roots.asDiagonal() * near.imag();
    segment.farReal = far.real();
    segment.farImaginary = far.imag();

    if (! segment.far.empty())
        segment.interpolation = roots.asDiagonal() * lagrange (omega, nodesAt);

    return segment;
}

Eigen::MatrixXd transposedProduct (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.cols(), b.cols());
    addTransposedLeft (result, 1, a, b);
    return result;
}

/** Re <functions, something> for near and far functions, added to the rows of a result. */
void addProducts (Eigen::MatrixXd& to, const Segment& segment, const Eigen::MatrixXd& real,
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

void addGramOf (Eigen::MatrixXd& gram, const Segment& segment)
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
        const auto segment = makeSegment (basis, data.omega.segment (first, count), roots);
        const Eigen::MatrixXcd values = roots.asDiagonal() * block (data, first, count, delay);
        addGramOf (result.gram, segment);
        addProducts (result.data, segment, values.real(), values.imag());
        result.energies += values.colwise().squaredNorm().transpose();
    }

    return result;
}
} // namespace antinode
