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

Eigen::VectorXcd response (ResponseEstimator estimator, const Eigen::ArrayXd& xx, const Eigen::ArrayXd& yy,
                           const Eigen::ArrayXcd& yx)
{
    const Eigen::ArrayXcd h1 = yx / xx.cast<std::complex<double>>();

    if (estimator == ResponseEstimator::h1)
        return h1;

    // |H2| / |H1| = S_xx S_yy / |S_yx|^2, 1 over the coherence.
    const Eigen::ArrayXd overH1 = xx * yy / yx.abs2().max (1e-300);
    return h1 * (estimator == ResponseEstimator::h2 ? overH1 : overH1.sqrt()).cast<std::complex<double>>();
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
    const auto x = blockSpectra (input, window, lines);
    const Eigen::ArrayXd xx = x.cwiseAbs2().rowwise().sum().array();

    if (! (xx.minCoeff() > 0))
        throw InputError ("recording", "has no input signal on a line to be measured");

    EstimatedResponses result;
    result.values.resize (x.rows(), outputs.rows());
    result.coherence.resize (x.rows(), outputs.rows());
    result.variances.resize (x.rows(), outputs.rows());
    const auto averages = std::max (1.0, static_cast<double> (x.cols()) / overlapLoss);

    for (Eigen::Index sensor = 0; sensor < outputs.rows(); ++sensor)
    {
        const auto y = blockSpectra (outputs.row (sensor), window, lines);
        const Eigen::ArrayXd yy = y.cwiseAbs2().rowwise().sum().array();
        const Eigen::ArrayXcd yx = y.cwiseProduct (x.conjugate()).rowwise().sum().array();
        const Eigen::ArrayXd coherence = (yx.abs2() / (xx * yy).max (1e-300)).min (1.0);
        result.values.col (sensor) = response (estimator, xx, yy, yx);
        result.coherence.col (sensor) = coherence;
        result.variances.col (sensor) =
            (yx / xx.cast<std::complex<double>>()).abs2() * (1 - coherence) / (coherence.max (1e-12) * averages);
    }

    // One block fits itself: it looks perfectly coherent and gives no information about its error.
    if (x.cols() < 2)
        result.coherence = result.variances = {};

    return result;
}
} // namespace antinode
