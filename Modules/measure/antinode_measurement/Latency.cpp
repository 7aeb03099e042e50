#include "Latency.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace antinode
{
namespace
{
constexpr double minimumCorrelation = 0.5;

/** Recording times conjugate signal: its phase falls by 2 pi f times the lag. */
Eigen::VectorXcd crossSpectrum (FourierTables& tables, const Excitation& excitation, const Eigen::VectorXd& sync,
                                Eigen::Index length)
{
    return tables.forward (sync, length).cwiseProduct (tables.forward (excitation.signal, length).conjugate());
}

/** The part of a sample, -1/2 to 1/2 and a little beyond, by which the largest correlation's lag is too small. */
double fractionalLag (const Eigen::VectorXcd& cross, Eigen::Index lag, Eigen::Index length)
{
    double numerator = 0, denominator = 0;
    const auto turn = 2 * std::numbers::pi / static_cast<double> (length);
    const auto sign = cross.dot (Eigen::VectorXcd::NullaryExpr (
        cross.size(), [&] (Eigen::Index k)
        { return std::polar (std::abs (cross[k]), -turn * static_cast<double> (k * lag % length)); }));
    const auto polarity = sign.real() < 0 ? -1.0 : 1.0;

    for (Eigen::Index k = 1; k < cross.size(); ++k)
    {
        const auto frequency = turn * static_cast<double> (k); // rad a sample
        const auto turnedBack = polarity * cross[k] * std::polar (1.0, turn * static_cast<double> (k * lag % length));
        const auto weight = std::abs (cross[k]);
        numerator -= weight * frequency * std::arg (turnedBack);
        denominator += weight * frequency * frequency;
    }

    return numerator / denominator;
}
} // namespace

double estimateLatency (const Excitation& excitation, const Eigen::VectorXd& sync)
{
    const auto samples = excitation.signal.size();
    const auto latest = sync.size() - samples;

    if (latest < 0)
        throw InputError ("sync channel", "has " + std::to_string (sync.size()) + " samples; allowed: at least "
                                              + std::to_string (samples) + " in a run");

    // Long enough for lags from -latest to latest not to fold onto each other.
    const auto length = quickLength (static_cast<double> (sync.size() + latest + 1));
    FourierTables tables;
    const auto cross = crossSpectrum (tables, excitation, sync, length);
    const auto correlation = tables.inverse (cross, length);
    Eigen::Index lag = 0;
    const auto largest = correlation.head (latest + 1).cwiseAbs().maxCoeff (&lag);
    const auto power = excitation.signal.norm() * sync.segment (lag, samples).norm();

    if (! (largest > minimumCorrelation * power))
        throw InputError (
            "sync channel",
            "does not contain the excitation signal: is the last output wired to this input, and is the "
            "latency below "
                + std::to_string (latest * 1000 / static_cast<Eigen::Index> (excitation.settings.sampleRate)) + " ms?");

    return std::max (0.0, static_cast<double> (lag) + fractionalLag (cross, lag, length));
}
} // namespace antinode
