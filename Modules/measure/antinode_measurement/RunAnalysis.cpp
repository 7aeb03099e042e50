#include "RunAnalysis.h"

#include "Latency.h"
#include "PeriodAverage.h"
#include "SweepDeconvolution.h"

#include <antinode_base/InputError.h>

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
} // namespace antinode
