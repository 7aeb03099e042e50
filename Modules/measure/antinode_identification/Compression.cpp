#include "Compression.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>

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
} // namespace antinode
