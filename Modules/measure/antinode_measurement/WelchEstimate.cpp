#include "WelchEstimate.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace antinode
{
namespace
{
/** 1 + 2 rho^2: rho = 1/6 is the correlation of neighbours' Hann windows that overlap by half. */
constexpr double overlapLoss = 1 + 2.0 / 36;

Eigen::VectorXd hann (Eigen::Index length)
{
    return Eigen::VectorXd::NullaryExpr (
        length,
        [&] (Eigen::Index n) {
            return 0.5 - 0.5 * std::cos (2 * std::numbers::pi * static_cast<double> (n) / static_cast<double> (length));
        });
}

/** The lines of all windowed blocks of a signal: blocks in columns. */
Eigen::MatrixXcd blockSpectra (const Eigen::VectorXd& signal, const Eigen::VectorXd& window,
                               const std::vector<Eigen::Index>& lines)
{
    const auto block = window.size(), step = block / 2;
    Eigen::MatrixXcd spectra (static_cast<Eigen::Index> (lines.size()), (signal.size() - block) / step + 1);

    for (Eigen::Index r = 0; r < spectra.cols(); ++r)
        spectra.col (r) = forwardFourier (signal.segment (r * step, block).cwiseProduct (window)) (lines);

    return spectra;
}
} // namespace

EstimatedResponses estimateByWelch (Eigen::Index block, const std::vector<Eigen::Index>& lines,
                                    ResponseEstimator estimator, const Eigen::VectorXd& input,
                                    const Eigen::MatrixXd& outputs)
{
    if (input.size() < block || outputs.cols() != input.size())
        throw InputError ("recording", "has " + std::to_string (outputs.cols())
                                           + " samples; allowed: at least those of a block, " + std::to_string (block));

    const auto window = hann (block);
    const AveragedSpectra spectra (blockSpectra (input, window, lines));

    if (! spectra.drivesAllLines())
        throw InputError ("recording", "has no input signal on a line to be measured");

    const auto blocks = (input.size() - block) / (block / 2) + 1, count = static_cast<Eigen::Index> (lines.size());
    const auto averages = std::max (1.0, static_cast<double> (blocks) / overlapLoss);
    EstimatedResponses result;
    result.values.resize (count, outputs.rows());
    result.coherence.resize (count, outputs.rows());
    result.variances.resize (count, outputs.rows());

    for (Eigen::Index sensor = 0; sensor < outputs.rows(); ++sensor)
        spectra.estimate (blockSpectra (outputs.row (sensor), window, lines), estimator, averages, sensor, result);

    // One block fits itself: it looks perfectly coherent and gives no information about its error.
    if (blocks < 2)
        result.coherence = result.variances = {};

    return result;
}
} // namespace antinode
