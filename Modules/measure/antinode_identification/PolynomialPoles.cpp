#include "PolynomialPoles.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr Eigen::Index fewestReferences = 4;

/** The strongest eigenvectors of a Gram matrix of which the lower triangle is given. */
Eigen::MatrixXd strongest (Eigen::MatrixXd gram, Eigen::Index count)
{
    const auto eigen = symmetricEigen (std::move (gram));
    return eigen.vectors.rightCols (std::min (count, eigen.vectors.cols())).rowwise().reverse();
}

Eigen::MatrixXd pointGram (const DataBlock& values, Eigen::Index points, Eigen::Index allReferences,
                           Eigen::Index stride)
{
    const auto lines = (values.real.rows() + stride - 1) / stride;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (points, points);

    for (Eigen::Index i = 0; i < allReferences; ++i)
        for (const auto* const part : { &values.real, &values.imaginary })
        {
            const Eigen::MatrixXd kept = (*part) (Eigen::seqN (0, lines, stride), Eigen::seqN (i * points, points));
            addTransposedLeft (gram, 1, kept, kept);
        }

    return gram;
}

Eigen::MatrixXd referenceGram (const std::vector<Eigen::MatrixXcd>& values)
{
    const auto allReferences = static_cast<Eigen::Index> (values.size());
    Eigen::MatrixXd gram (allReferences, allReferences);

    for (Eigen::Index i = 0; i < allReferences; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            gram (i, j) =
                (values[static_cast<std::size_t> (i)].conjugate().cwiseProduct (values[static_cast<std::size_t> (j)]))
                    .sum()
                    .real();

    return gram;
}

/** Outputs in the place of references, by reciprocity of the poles: shapes then distinguish modes that few references
    cannot. */
CompressedBand exchanged (CompressedBand band, const std::vector<Eigen::MatrixXcd>& projected, Eigen::Index references)
{
    const auto allReferences = static_cast<Eigen::Index> (projected.size());

    for (Eigen::Index r = 0; r < std::min (references, projected.front().cols()); ++r)
    {
        Eigen::MatrixXcd values (band.lines(), allReferences);

        for (Eigen::Index i = 0; i < allReferences; ++i)
            values.col (i) = projected[static_cast<std::size_t> (i)].col (r);

        band.values.push_back (std::move (values));
    }

    return band;
}
} // namespace

CompressedBand compress (const PreparedResponses& data, Eigen::Index first, Eigen::Index count, Eigen::Index outputs,
                         Eigen::Index references)
{
    const auto points = data.points(), allReferences = data.references();
    auto values = dataBlock (data, first, Eigen::VectorXcd::Ones (count));
    const Eigen::VectorXd roots = data.columnWeights.cwiseSqrt();
    const auto scale = data.lineScale.segment (first, count).asDiagonal();
    values.real = scale * values.real * roots.asDiagonal();
    values.imaginary = scale * values.imaginary * roots.asDiagonal();

    // Directions need no more than some thousand samples; the values themselves keep every line.
    const auto stride = std::max<Eigen::Index> (1, count * allReferences / 8192);
    const auto directions = strongest (pointGram (values, points, allReferences, stride), outputs);
    std::vector<Eigen::MatrixXcd> projected;

    for (Eigen::Index i = 0; i < allReferences; ++i)
    {
        Eigen::MatrixXd real = Eigen::MatrixXd::Zero (count, directions.cols()), imaginary = real;
        addProduct (real, 1, values.real.middleCols (i * points, points), directions);
        addProduct (imaginary, 1, values.imaginary.middleCols (i * points, points), directions);
        projected.emplace_back (count, directions.cols());
        projected.back().real() = real;
        projected.back().imag() = imaginary;
    }

    CompressedBand band;
    band.omega = data.omega.segment (first, count);

    if (allReferences < fewestReferences && directions.cols() > allReferences)
        return exchanged (std::move (band), projected, references);

    if (allReferences <= references)
    {
        band.values = std::move (projected);
        return band;
    }

    const auto mixture = strongest (referenceGram (projected), references);

    for (Eigen::Index j = 0; j < mixture.cols(); ++j)
    {
        band.values.emplace_back (Eigen::MatrixXcd::Zero (count, directions.cols()));

        for (Eigen::Index i = 0; i < allReferences; ++i)
            band.values.back() += mixture (i, j) * projected[static_cast<std::size_t> (i)];
    }

    return band;
}

namespace
{
using Matrix = Eigen::MatrixXcd;

/** What share of the unit circle a band covers: on all of it its two ends would be one. */
constexpr double circleShare = 0.9;

double secondsOfBasis (const CompressedBand& band)
{
    return 2 * std::numbers::pi * circleShare / (band.omega[band.lines() - 1] - band.omega[0]);
}

/** Sums over the lines for all differences of powers of z = exp ((s - i omega_0) T): they make every normal equation.
 */
struct LagSums
{
    Eigen::VectorXcd basis;         ///< Of z^lag, lag 0 to order.
    std::vector<Matrix> numerators; ///< Of z^lag H, lag -order to order: references x outputs.
    std::vector<Matrix>
        denominators; ///< Of z^lag conj (H) H', lag 0 to order: references x references, summed over outputs.
};

/** @param ofPairs  sums of z^lag conj (H) H', lag -order to order, one column for each pair of references */
void addDenominators (LagSums& sums, const Matrix& ofPairs, Eigen::Index order)
{
    for (Eigen::Index lag = 0; lag <= order; ++lag)
    {
        auto& sum = sums.denominators[static_cast<std::size_t> (lag)];
        Eigen::Index pair = 0;

        for (Eigen::Index i = 0; i < sum.rows(); ++i)
            for (Eigen::Index j = 0; j <= i; ++j, ++pair)
            {
                sum (i, j) = ofPairs (order + lag, pair);
                sum (j, i) = std::conj (ofPairs (order - lag, pair));
            }
    }
}

LagSums sumOverLines (const CompressedBand& band, Eigen::Index order)
{
    const auto lines = band.lines(), references = band.references(), outputs = band.outputs();
    const auto seconds = secondsOfBasis (band);
    const Eigen::ArrayXd angles = (band.omega.array() - band.omega[0]) * seconds;
    Matrix powers (lines, 2 * order + 1);

    for (Eigen::Index f = 0; f < lines; ++f)
    {
        const auto step = std::polar (1.0, angles[f]);
        powers (f, order) = 1;

        for (Eigen::Index lag = 1; lag <= order; ++lag)
        {
            powers (f, order + lag) = powers (f, order + lag - 1) * step;
            powers (f, order - lag) = std::conj (powers (f, order + lag));
        }
    }

    LagSums sums;
    sums.basis = powers.rightCols (order + 1).colwise().sum().transpose();
    sums.numerators.assign (static_cast<std::size_t> (2 * order + 1), Matrix (references, outputs));
    sums.denominators.assign (static_cast<std::size_t> (order + 1), Matrix (references, references));

    // One column for each pair of references, the first not below the second.
    Matrix between (lines, references * (references + 1) / 2);
    Eigen::Index pair = 0;

    for (Eigen::Index i = 0; i < references; ++i)
    {
        const auto& values = band.values[static_cast<std::size_t> (i)];
        const auto products = productTransposedLeft (powers, values);

        for (Eigen::Index lag = 0; lag <= 2 * order; ++lag)
            sums.numerators[static_cast<std::size_t> (lag)].row (i) = products.row (lag);

        for (Eigen::Index j = 0; j <= i; ++j)
            between.col (pair++) =
                values.conjugate().cwiseProduct (band.values[static_cast<std::size_t> (j)]).rowwise().sum();
    }

    addDenominators (sums, productTransposedLeft (powers, between), order);
    return sums;
}

Matrix toeplitzOfBasis (const LagSums& sums, Eigen::Index size)
{
    Matrix result (size, size);

    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index k = 0; k < size; ++k)
            result (j, k) = k >= j ? sums.basis[k - j] : std::conj (sums.basis[j - k]);

    return result;
}

/** Normal equations of the denominator's coefficients, numerators eliminated: (order + 1) blocks of references. */
Matrix normalEquations (const LagSums& sums, Eigen::Index order, Eigen::Index maximum)
{
    const auto references = sums.denominators.front().rows(), outputs = sums.numerators.front().cols();
    const auto size = order + 1;
    Matrix result (size * references, size * references);

    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index k = j; k < size; ++k)
        {
            const auto& sum = sums.denominators[static_cast<std::size_t> (k - j)];
            result.block (j * references, k * references, references, references) = sum;
            result.block (k * references, j * references, references, references) = sum.adjoint();
        }

    // All outputs side by side: rows are powers of the numerator, columns the denominator's coefficients of one output.
    auto factor = toeplitzOfBasis (sums, size);
    factorLower (factor);
    Matrix between (size, size * references), ofAll (outputs * size, size * references);

    for (Eigen::Index o = 0; o < outputs; ++o)
    {
        checkWatch();

        for (Eigen::Index j = 0; j < size; ++j)
            for (Eigen::Index k = 0; k < size; ++k)
                between.block (j, k * references, 1, references) =
                    sums.numerators[static_cast<std::size_t> (k - j + maximum)].col (o).transpose();

        solveLower (factor, between);
        ofAll.middleRows (o * size, size) = between;
    }

    return result - adjointGram (ofAll);
}

/** The coefficients of z^1 to z^order, that of z^0 being the unit matrix, as blocks of rows. */
Matrix coefficients (Matrix normal, Eigen::Index references, double ridge)
{
    const auto unknowns = normal.rows() - references;
    normal.diagonal().array() += ridge * normal.diagonal().real().mean();
    return -solveSemidefinite (Matrix (normal.bottomRightCorner (unknowns, unknowns)),
                               Matrix (normal.bottomLeftCorner (unknowns, references)));
}

/** The vector that I + z A_1' + ... + z^n A_n' maps to nearly zero, by inverse iteration: the participation of a pole.
 */
Eigen::RowVectorXcd participationOf (std::complex<double> z, const Matrix& blocks, Eigen::Index references)
{
    constexpr int steps = 3;
    Matrix sum = Matrix::Identity (references, references);
    auto power = z;

    for (Eigen::Index j = 0; j < blocks.rows(); j += references, power *= z)
        sum += power * blocks.middleRows (j, references).transpose();

    Matrix gram = adjointGram (sum);
    gram.diagonal().array() += 1e-15 * std::max (gram.diagonal().real().sum(), 1e-300);
    Matrix vector = Matrix::Ones (references, 1);

    for (int step = 0; step < steps; ++step)
        vector = solveSemidefinite (gram, vector).normalized();

    return vector.col (0).transpose();
}

/** Solutions of l' (w^n + w^(n-1) A_1 + ... + A_n) = 0, w = 1 / z, by the companion matrix. */
OrderPoles computePoles (const Matrix& blocks, Eigen::Index references, const CompressedBand& band)
{
    const auto size = blocks.rows(), order = size / references;
    Matrix companion = Matrix::Zero (size, size);

    for (Eigen::Index j = 0; j < order; ++j)
        companion.block (0, j * references, references, references) =
            -blocks.middleRows (j * references, references).transpose();

    companion.bottomLeftCorner (size - references, size - references).setIdentity();
    const auto eigenvalues = complexEigenvalues (companion);
    const auto seconds = secondsOfBasis (band);
    OrderPoles result { static_cast<int> (order), Eigen::VectorXcd (size), Matrix (size, references) };
    Eigen::Index count = 0;

    if (! eigenvalues)
        return { static_cast<int> (order), {}, Matrix (0, references) };

    for (Eigen::Index n = 0; n < size; ++n)
    {
        const auto w = (*eigenvalues)[n];

        if (std::abs (w) <= 1) // unstable, or exactly 0
            continue;

        // The lines lie at angles from 0 to 0.9 of a full circle; the rest is split between both sides.
        auto angle = -std::arg (w);
        angle += angle < -std::numbers::pi * (1 - circleShare) ? 2 * std::numbers::pi : 0;
        const std::complex<double> pole (-std::log (std::abs (w)) / seconds, band.omega[0] + angle / seconds);

        if (! std::isfinite (pole.real()) || ! std::isfinite (pole.imag()) || pole.imag() <= 0)
            continue;

        result.poles[count] = pole;
        result.participation.row (count) = participationOf (1.0 / w, blocks, references);
        ++count;
    }

    result.poles.conservativeResize (count);
    result.participation.conservativeResize (count, references);
    return result;
}
} // namespace

std::vector<OrderPoles> polynomialPoles (const CompressedBand& band, int minimumOrder, int maximumOrder, double ridge,
                                         const std::function<bool (const std::vector<OrderPoles>&)>& isEnough)
{
    const auto sums = sumOverLines (band, maximumOrder);
    std::vector<OrderPoles> result;

    for (auto order = minimumOrder; order <= maximumOrder && ! isEnough (result); ++order)
    {
        const auto blocks = coefficients (normalEquations (sums, order, maximumOrder), band.references(), ridge);
        checkWatch();
        result.push_back (computePoles (blocks, band.references(), band));
        checkWatch();
    }

    return result;
}
} // namespace antinode
