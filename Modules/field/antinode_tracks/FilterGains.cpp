#include "FilterGains.h"

#include <antinode_numerics/Fourier.h>

#include <cmath>

namespace antinode
{
namespace
{
/** The root of the mean square of a filter's response over a band. */
double bandGain (FourierTables& tables, const Eigen::VectorXd& taps, double rate, TrackBand band)
{
    const auto length = quickLength (2 * static_cast<double> (taps.size()));
    const auto perLine = rate / static_cast<double> (length);
    const auto first = static_cast<Eigen::Index> (std::ceil (band.lower / perLine));
    const auto count = static_cast<Eigen::Index> (std::floor (band.upper / perLine)) - first + 1;
    const auto lines = tables.forward (taps, length);
    return std::sqrt (lines.segment (first, count).squaredNorm() / static_cast<double> (count));
}
} // namespace

Eigen::MatrixXd noiseGains (const FingerFilters& filters, TrackBand band)
{
    Eigen::MatrixXd gains (filters.taps.front().cols(), static_cast<Eigen::Index> (filters.taps.size()));
    FourierTables tables;

    for (Eigen::Index j = 0; j < gains.cols(); ++j)
        for (Eigen::Index i = 0; i < gains.rows(); ++i)
            gains (i, j) = bandGain (tables, filters.taps[static_cast<std::size_t> (j)].col (i), filters.rate(), band);

    return gains;
}
} // namespace antinode
