#include "FeltElsewhere.h"

#include <antinode_numerics/DenseKernels.h>

#include <utility>

namespace antinode
{
FeltElsewhere::FeltElsewhere (FeltLines linesToUse, const QuietBasis& basis, const Eigen::MatrixXd& participation,
                              double sampleRate)
    : lines (std::move (linesToUse)), splines (spectraOn (lines, basis.splineWaves(), sampleRate))
{
    const auto spectra = spectraOn (lines, basis.rowWaveforms(), sampleRate);
    const auto count = lines.frequencies.size();
    const Eigen::MatrixXd real = spectra.leftCols (count), imaginary = spectra.rightCols (count);

    for (std::size_t p = 0; p < lines.real.size(); ++p)
    {
        const Eigen::MatrixXd a = participation * lines.real[p], b = participation * lines.imaginary[p];
        Eigen::MatrixXd seen (spectra.rows(), 2 * count);
        seen.leftCols (count) = a.cwiseProduct (real) - b.cwiseProduct (imaginary);
        seen.rightCols (count) = a.cwiseProduct (imaginary) + b.cwiseProduct (real);
        rows.push_back (seen.transpose());
    }
}

Eigen::MatrixXd FeltElsewhere::ofSamples (const Eigen::MatrixXd& samples, double sampleRate) const
{
    return ofSpectra (spectraOn (lines, samples, sampleRate));
}

Eigen::MatrixXd FeltElsewhere::ofCorrection (const QuietCorrection& change) const
{
    Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero (change.splines.rows(), splines.cols());
    addProduct (spectra, 1, change.splines, splines);
    auto felt = ofSpectra (spectra);

    for (std::size_t p = 0; p < rows.size(); ++p)
        felt.col (static_cast<Eigen::Index> (p)) -= rows[p] * change.rows;

    return felt;
}

QuietCorrection FeltElsewhere::slope (const Eigen::MatrixXd& felt) const
{
    const auto count = lines.frequencies.size();
    Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero (lines.real.front().rows(), 2 * count);
    Eigen::VectorXd pulls = Eigen::VectorXd::Zero (rows.front().cols());

    for (std::size_t p = 0; p < rows.size(); ++p)
    {
        const auto column = felt.col (static_cast<Eigen::Index> (p));
        const auto real = column.head (count).asDiagonal(), imaginary = column.tail (count).asDiagonal();
        spectra.leftCols (count) += lines.real[p] * real + lines.imaginary[p] * imaginary;
        spectra.rightCols (count) += lines.real[p] * imaginary - lines.imaginary[p] * real;
        pulls -= rows[p].transpose() * column;
    }

    QuietCorrection result { Eigen::MatrixXd::Zero (spectra.rows(), splines.rows()), std::move (pulls) };
    addTransposedRight (result.splines, 1, spectra, splines);
    return result;
}

Eigen::MatrixXd FeltElsewhere::ofSpectra (const Eigen::MatrixXd& spectra) const
{
    const auto count = lines.frequencies.size();
    const auto real = spectra.leftCols (count), imaginary = spectra.rightCols (count);
    Eigen::MatrixXd felt (2 * count, static_cast<Eigen::Index> (lines.real.size()));

    for (std::size_t p = 0; p < lines.real.size(); ++p)
    {
        const auto &a = lines.real[p], &b = lines.imaginary[p];
        auto column = felt.col (static_cast<Eigen::Index> (p));
        column.head (count) = (a.cwiseProduct (real) - b.cwiseProduct (imaginary)).colwise().sum().transpose();
        column.tail (count) = (a.cwiseProduct (imaginary) + b.cwiseProduct (real)).colwise().sum().transpose();
    }

    return felt;
}
} // namespace antinode
