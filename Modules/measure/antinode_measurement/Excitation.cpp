#include "Excitation.h"

#include "Multisine.h"
#include "Sweep.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace antinode
{
namespace
{
constexpr double fadeTime = 0.01, silenceTime = 0.25; // s
constexpr double maximumSamples = 1 << 24;            // of a run
constexpr double highestRateFraction = 0.45;          // what converters' filters leave alone

template <typename... Parts>
std::string text (const Parts&... parts)
{
    std::ostringstream stream;
    stream.precision (9);
    (stream << ... << parts);
    return stream.str();
}

void require (bool fulfilled, const std::string& where, const std::string& wrong)
{
    if (! fulfilled)
        throw InputError ("excitation: " + where, wrong);
}

void checkBand (const ExcitationSettings& settings)
{
    const auto rate = settings.sampleRate, low = settings.lowestFrequency, high = settings.highestFrequency;
    require (rate >= 8e3 && rate <= 2e6 && rate == std::floor (rate), "sample rate",
             text ("is ", rate, " Hz; allowed: whole numbers from 8000 to 2000000 Hz"));
    require (high > 0 && high <= highestRateFraction * rate, "highest frequency",
             text ("is ", high, " Hz; allowed: above 0 to ", highestRateFraction * rate, " Hz at this sample rate"));
    require (low > 0 && low < high, "lowest frequency",
             text ("is ", low, " Hz; allowed: above 0 to below the highest frequency, ", high, " Hz"));
    require (
        settings.resolution >= 0.01 && settings.resolution <= (high - low) / 4, "resolution",
        text ("is ", settings.resolution, " Hz; allowed: 0.01 Hz to a quarter of the band, ", (high - low) / 4, " Hz"));
}

void checkLengths (const ExcitationSettings& settings)
{
    const auto isSweep = settings.signal == ExcitationSignal::sweep;
    require (settings.periods >= 1 && settings.periods <= 10000, "periods",
             text ("are ", settings.periods, "; allowed: 1 to 10000"));
    require (settings.settlingPeriods >= 1 && settings.settlingPeriods <= 10000, "settling periods",
             text ("are ", settings.settlingPeriods, "; allowed: 1 to 10000"));
    require (settings.sweepDuration >= 0.1 && settings.sweepDuration <= 600, "duration of the sweep",
             text ("is ", settings.sweepDuration, " s; allowed: 0.1 to 600 s"));
    require (! settings.hasOddGrid || settings.signal == ExcitationSignal::multisine, "odd lines",
             "are possible for the multisine only");

    const auto blocks = isSweep ? settings.periods * (settings.sweepDuration + 1 / settings.resolution)
                                : (settings.periods + settings.settlingPeriods) / settings.resolution;
    require (blocks * settings.sampleRate <= maximumSamples, "duration of a run",
             text ("is ", blocks, " s; allowed: up to ", maximumSamples / settings.sampleRate,
                   " s at this sample rate; choose fewer periods or a coarser resolution"));
}

void checkLevels (const ExcitationSettings& settings, const Eigen::VectorXd& limits)
{
    require (settings.levels.size() > 0 && settings.levels.size() == limits.size(), "levels",
             text ("are ", settings.levels.size(), "; allowed: one for each of the ", limits.size(), " ceramics"));

    for (Eigen::Index i = 0; i < limits.size(); ++i)
        require (settings.levels[i] > 0 && settings.levels[i] <= limits[i], text ("level of ceramic ", i + 1),
                 text ("is ", settings.levels[i], " V; allowed: above 0 to its limit, ", limits[i], " V"));
}

/** As many blocks as requested, plus the fade-out. */
Eigen::Index playedSamples (const Excitation& excitation)
{
    const auto& settings = excitation.settings;

    if (settings.signal == ExcitationSignal::sweep)
        return settings.periods * excitation.block;

    return (settings.settlingPeriods + settings.periods) * excitation.block
           + std::min (excitation.block, static_cast<Eigen::Index> (fadeTime * settings.sampleRate));
}

/** The last part of a block's rhythm, in which it fades out, is as long as that in which it fades in. */
void fadeEnds (const Excitation& excitation, Eigen::VectorXd& signal)
{
    const auto samples = signal.size() % excitation.block;

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto gain =
            0.5 - 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (samples));
        signal[n] *= gain;
        signal[signal.size() - 1 - n] *= gain;
    }
}

Eigen::VectorXd multisine (const Excitation& excitation)
{
    auto period = multisinePeriod (excitation.lines, excitation.block);
    period /= peakBetweenSamples (period);
    Eigen::VectorXd signal = Eigen::VectorXd::NullaryExpr (playedSamples (excitation),
                                                           [&] (Eigen::Index n) { return period[n % period.size()]; });
    fadeEnds (excitation, signal);
    return signal;
}

Eigen::VectorXd noise (const Excitation& excitation)
{
    const auto& settings = excitation.settings;
    const auto samples = playedSamples (excitation), length = quickLength (static_cast<double> (samples));
    const auto margin =
        2 * settings.resolution; // A window's width, so that the band's outermost lines are driven like the others.
    auto spectrum = forwardFourier (RandomNumbers (settings.seed).normal (length));

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
    {
        const auto frequency = static_cast<double> (k) * settings.sampleRate / static_cast<double> (length);

        if (frequency < settings.lowestFrequency - margin || frequency > settings.highestFrequency + margin)
            spectrum[k] = 0;
    }

    Eigen::VectorXd signal = inverseFourier (spectrum, length).head (samples);
    signal /= peakBetweenSamples (signal);
    fadeEnds (excitation, signal);
    return signal;
}

Sweep sweepFromSettings (const ExcitationSettings& settings)
{
    return makeSweep (settings.lowestFrequency, settings.highestFrequency, settings.sweepDuration, settings.sampleRate);
}

Eigen::VectorXd repeatedSweep (const Excitation& excitation)
{
    auto samples = sweepFromSettings (excitation.settings).samples;
    samples /= peakBetweenSamples (samples);
    Eigen::VectorXd signal = Eigen::VectorXd::Zero (playedSamples (excitation));

    for (Eigen::Index first = 0; first < signal.size(); first += excitation.block)
        signal.segment (first, samples.size()) = samples;

    return signal;
}

/** Everything but the signal. */
Excitation laidOut (const ExcitationSettings& settings, const Eigen::VectorXd& voltageLimits)
{
    checkBand (settings);
    checkLengths (settings);
    checkLevels (settings, voltageLimits);
    Excitation excitation;
    excitation.settings = settings;
    // Every second line at most of an odd grid is driven.
    excitation.lineBlock = quickLength ((settings.hasOddGrid ? 2 : 1) * settings.sampleRate / settings.resolution);
    excitation.block = excitation.lineBlock;

    if (settings.signal == ExcitationSignal::sweep)
        excitation.block += sweepFromSettings (settings).samples.size();

    const auto perLine = static_cast<double> (excitation.lineBlock) / settings.sampleRate;
    const auto lowest = static_cast<Eigen::Index> (std::ceil (settings.lowestFrequency * perLine));
    const auto highest = static_cast<Eigen::Index> (std::floor (settings.highestFrequency * perLine));
    excitation.lines =
        settings.hasOddGrid ? oddRandomLines (lowest, highest, settings.seed) : everyLine (lowest, highest);
    excitation.runLength = playedSamples (excitation) + static_cast<Eigen::Index> (silenceTime * settings.sampleRate);
    return excitation;
}

Excitation withSignal (Excitation excitation, Eigen::VectorXd signal)
{
    const auto isSweep = excitation.settings.signal == ExcitationSignal::sweep;
    const auto sounding = signal.head (isSweep ? excitation.block - excitation.lineBlock : excitation.block);
    excitation.crestFactor = std::sqrt (static_cast<double> (sounding.size())) / sounding.norm();
    excitation.signal = std::move (signal);
    return excitation;
}
} // namespace

Excitation makeExcitation (const ExcitationSettings& settings, const Eigen::VectorXd& voltageLimits)
{
    auto excitation = laidOut (settings, voltageLimits);

    switch (settings.signal)
    {
        case ExcitationSignal::multisine:
            return withSignal (excitation, multisine (excitation));
        case ExcitationSignal::noise:
            return withSignal (excitation, noise (excitation));
        case ExcitationSignal::sweep:
            break;
    }

    return withSignal (excitation, repeatedSweep (excitation));
}

Excitation excitationWith (const ExcitationSettings& settings, const Eigen::VectorXd& voltageLimits,
                           const Eigen::VectorXd& signal)
{
    auto excitation = laidOut (settings, voltageLimits);
    constexpr double rounding = 1e-6;

    if (signal.size() != playedSamples (excitation) || ! (signal.cwiseAbs().maxCoeff() <= 1 + rounding)
        || signal.isZero())
        throw InputError ("excitation: signal",
                          text ("has ", signal.size(), " samples and does not fit these settings; allowed: ",
                                playedSamples (excitation), " samples with a peak of at most 1"));

    return withSignal (std::move (excitation), signal);
}

Eigen::MatrixXd playedRun (const Excitation& excitation, Eigen::Index ceramic, double fullScale)
{
    Eigen::MatrixXd played = Eigen::MatrixXd::Zero (excitation.ceramics() + 1, excitation.runLength);
    const auto samples = excitation.signal.size();
    played.row (ceramic).head (samples) =
        excitation.settings.levels[ceramic] / fullScale * excitation.signal.transpose();
    played.bottomRows (1).leftCols (samples) = syncLevel * excitation.signal.transpose();
    return played;
}

Eigen::VectorXd measuredFrequencies (const Excitation& excitation)
{
    Eigen::VectorXd frequencies (static_cast<Eigen::Index> (excitation.lines.size()));

    for (Eigen::Index i = 0; i < frequencies.size(); ++i)
        frequencies[i] = excitation.lineFrequency (excitation.lines[static_cast<std::size_t> (i)]);

    return frequencies;
}
} // namespace antinode
