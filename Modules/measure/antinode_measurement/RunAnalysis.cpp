#include "RunAnalysis.h"

#include "EstimatedResponses.h"

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
/** The samples of a run that are evaluated. */
struct Measured
{
    Eigen::Index first = 0, count = 0;
};

Measured measuredPart (const Excitation& excitation)
{
    const auto& settings = excitation.settings;
    const auto settling = settings.signal == ExcitationSignal::sweep ? 0 : settings.settlingPeriods;
    return { settling * excitation.block, settings.periods * excitation.block };
}

void requireUsable (const Excitation& excitation, const RunRecording& recording, Eigen::Index needed)
{
    const auto samples = recording.sensors.cols();
    const auto agrees = [samples] (const Eigen::VectorXd& channel)
    { return channel.size() == 0 || channel.size() == samples; };

    if (samples < needed || ! agrees (recording.sync) || ! agrees (recording.reference))
        throw InputError ("recording", "has " + std::to_string (samples) + " samples in a run; allowed: at least "
                                           + std::to_string (needed) + ", equally many on every channel; a run has "
                                           + std::to_string (excitation.runLength));

    if (! recording.sensors.allFinite() || ! recording.sync.allFinite() || ! recording.reference.allFinite())
        throw InputError ("recording", "has a sample that is not finite");
}

EstimatedResponses estimate (const Excitation& excitation, ResponseEstimator estimator, const Eigen::VectorXd& input,
                             const Eigen::MatrixXd& outputs)
{
    const auto& settings = excitation.settings;

    switch (settings.signal)
    {
        case ExcitationSignal::multisine:
            return averagePeriods ({ excitation.block, excitation.lines, settings.hasOddGrid }, input, outputs);
        case ExcitationSignal::noise:
            return estimateByWelch (excitation.block, excitation.lines, estimator, input, outputs);
        case ExcitationSignal::sweep:
            break;
    }

    const auto sweep =
        makeSweep (settings.lowestFrequency, settings.highestFrequency, settings.sweepDuration, settings.sampleRate);
    return deconvolveSweep ({ sweep, settings.sampleRate, settings.lowestFrequency, settings.highestFrequency,
                              excitation.block, excitation.lineBlock, excitation.lines },
                            input, outputs);
}

/** A recording that is late by a number of samples has its phase rotated by exp (-i omega late): rotates it back. */
void takeOutDelay (Eigen::MatrixXcd& values, const Excitation& excitation, double samples)
{
    const auto perHertz = 2 * std::numbers::pi * samples / excitation.settings.sampleRate;
    const auto frequencies = measuredFrequencies (excitation);

    for (Eigen::Index f = 0; f < frequencies.size(); ++f)
        values.row (f) *= std::polar (1.0, perHertz * frequencies[f]);
}
} // namespace

RunResponses analyseRun (const Excitation& excitation, Eigen::Index ceramic, const RunRecording& recording,
                         const RunAnalysisSettings& settings)
{
    const auto part = measuredPart (excitation);
    requireUsable (excitation, recording, part.first + part.count);
    RunResponses result;
    result.latency = recording.sync.size() > 0 ? estimateLatency (excitation, recording.sync) : settings.latency;
    const auto late = static_cast<Eigen::Index> (std::floor (result.latency));
    requireUsable (excitation, recording, late + part.first + part.count);

    const auto isMeasured = recording.reference.size() > 0;
    const Eigen::VectorXd input = isMeasured
                                      ? Eigen::VectorXd (recording.reference.segment (late + part.first, part.count))
                                      : Eigen::VectorXd (excitation.settings.levels[ceramic]
                                                         * excitation.signal.segment (part.first, part.count));
    result.responses =
        estimate (excitation, settings.estimator, input, recording.sensors.middleCols (late + part.first, part.count));

    if (! isMeasured)
        takeOutDelay (result.responses.values, excitation, result.latency - static_cast<double> (late));

    return result;
}

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
