#include "Excitation.h"

#include "Fourier.h"
#include "Multisine.h"
#include "RandomNumbers.h"
#include "Sweep.h"

#include <antinode_model/InputError.h>

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
constexpr double mostSamples = 1 << 24;               // of a turn
constexpr double highestOfRate = 0.45;                // what converters' filters leave alone

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
             text ("is ", rate, " Hz, allowed are whole numbers from 8000 to 2000000"));
    require (high > 0 && high <= highestOfRate * rate, "highest frequency",
             text ("is ", high, " Hz, allowed is more than 0 to ", highestOfRate * rate, " Hz at this sample rate"));
    require (low > 0 && low < high, "lowest frequency",
             text ("is ", low, " Hz, allowed is more than 0 and less than the highest, ", high, " Hz"));
    require (settings.resolution >= 0.01 && settings.resolution <= (high - low) / 4, "resolution",
             text ("is ", settings.resolution, " Hz, allowed is 0.01 to a quarter of the band, ", (high - low) / 4));
}

void checkLengths (const ExcitationSettings& settings)
{
    const auto isSweep = settings.signal == ExcitationSignal::sweep;
    require (settings.periods >= 1 && settings.periods <= 10000, "periods",
             text ("are ", settings.periods, ", allowed are 1 to 10000"));
    require (settings.settlingPeriods >= 1 && settings.settlingPeriods <= 10000, "settling periods",
             text ("are ", settings.settlingPeriods, ", allowed are 1 to 10000"));
    require (settings.sweepDuration >= 0.1 && settings.sweepDuration <= 600, "duration of the sweep",
             text ("is ", settings.sweepDuration, " s, allowed is 0.1 to 600"));
    require (! settings.hasOddGrid || settings.signal == ExcitationSignal::multisine, "odd lines",
             "are for the multisine only");

    const auto blocks = isSweep ? settings.periods * (settings.sweepDuration + 1 / settings.resolution)
                                : (settings.periods + settings.settlingPeriods) / settings.resolution;
    require (blocks * settings.sampleRate <= mostSamples, "duration",
             text ("of a ceramic's turn is ", blocks, " s, allowed is ", mostSamples / settings.sampleRate,
                   " s at this sample rate: take fewer periods or a coarser resolution"));
}

void checkLevels (const ExcitationSettings& settings, const Eigen::VectorXd& limits)
{
    require (settings.levels.size() > 0 && settings.levels.size() == limits.size(), "levels",
             text ("are ", settings.levels.size(), ", allowed is one for each of the ", limits.size(), " ceramics"));

    for (Eigen::Index i = 0; i < limits.size(); ++i)
        require (settings.levels[i] > 0 && settings.levels[i] <= limits[i], text ("level of ceramic ", i + 1),
                 text ("is ", settings.levels[i], " V, allowed is more than 0 to its limit, ", limits[i], " V"));
}

/** Begins and ends without a click. */
void fadeEnds (Eigen::VectorXd& signal, Eigen::Index samples)
{
    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto gain =
            0.5 - 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (samples));
        signal[n] *= gain;
        signal[signal.size() - 1 - n] *= gain;
    }
}

/** Makes the peak between the samples 1. @return the crest factor */
double normalise (Eigen::VectorXd& signal)
{
    signal /= peakBetweenSamples (signal);
    return std::sqrt (static_cast<double> (signal.size())) / signal.norm();
}

/** As many blocks as are asked for and a little more, in which it fades out. */
Eigen::Index playedSamples (const ExcitationSettings& settings, Eigen::Index block)
{
    return (settings.settlingPeriods + settings.periods) * block
           + std::min (block, static_cast<Eigen::Index> (fadeTime * settings.sampleRate));
}

void makeMultisine (Excitation& excitation)
{
    const auto& settings = excitation.settings;
    auto period = multisinePeriod (excitation.lines, excitation.block);
    excitation.crestFactor = normalise (period);
    excitation.signal.resize (playedSamples (settings, excitation.block));

    for (Eigen::Index n = 0; n < excitation.signal.size(); ++n)
        excitation.signal[n] = period[n % period.size()];

    fadeEnds (excitation.signal,
              excitation.signal.size() - (settings.settlingPeriods + settings.periods) * excitation.block);
}

void makeNoise (Excitation& excitation)
{
    const auto& settings = excitation.settings;
    const auto samples = playedSamples (settings, excitation.block);
    const auto length = quickLength (static_cast<double> (samples));
    auto spectrum = spectrumOf (RandomNumbers (settings.seed).normal (length));

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
    {
        const auto frequency = static_cast<double> (k) * settings.sampleRate / static_cast<double> (length);

        // A window's width beyond the band, so that its outermost lines are driven like the others.
        if (frequency < settings.lowestFrequency - 2 * settings.resolution
            || frequency > settings.highestFrequency + 2 * settings.resolution)
            spectrum[k] = 0;
    }

    excitation.signal = signalOf (spectrum, length).head (samples);
    excitation.crestFactor = normalise (excitation.signal);
    fadeEnds (excitation.signal, samples - (settings.settlingPeriods + settings.periods) * excitation.block);
}

void makeRepeatedSweep (Excitation& excitation)
{
    const auto& settings = excitation.settings;
    auto sweep =
        makeSweep (settings.lowestFrequency, settings.highestFrequency, settings.sweepDuration, settings.sampleRate);
    excitation.crestFactor = normalise (sweep.samples);
    excitation.block = sweep.samples.size() + excitation.lineBlock;
    excitation.signal = Eigen::VectorXd::Zero (settings.periods * excitation.block);

    for (int i = 0; i < settings.periods; ++i)
        excitation.signal.segment (i * excitation.block, sweep.samples.size()) = sweep.samples;
}
} // namespace

Excitation makeExcitation (const ExcitationSettings& settings, const Eigen::VectorXd& voltageLimits)
{
    checkBand (settings);
    checkLengths (settings);
    checkLevels (settings, voltageLimits);

    Excitation excitation;
    excitation.settings = settings;
    // Every second line at most of an odd grid is driven.
    excitation.lineBlock = quickLength ((settings.hasOddGrid ? 2 : 1) * settings.sampleRate / settings.resolution);
    excitation.block = excitation.lineBlock;

    const auto perLine = static_cast<double> (excitation.lineBlock) / settings.sampleRate;
    const auto lowest = static_cast<Eigen::Index> (std::ceil (settings.lowestFrequency * perLine));
    const auto highest = static_cast<Eigen::Index> (std::floor (settings.highestFrequency * perLine));
    excitation.lines =
        settings.hasOddGrid ? oddRandomLines (lowest, highest, settings.seed) : everyLine (lowest, highest);

    switch (settings.signal)
    {
        case ExcitationSignal::multisine:
            makeMultisine (excitation);
            break;
        case ExcitationSignal::sweep:
            makeRepeatedSweep (excitation);
            break;
        case ExcitationSignal::noise:
            makeNoise (excitation);
            break;
    }

    excitation.turn = excitation.signal.size() + static_cast<Eigen::Index> (silenceTime * settings.sampleRate);
    return excitation;
}

Eigen::MatrixXd playedTurn (const Excitation& excitation, Eigen::Index ceramic, double fullScale)
{
    Eigen::MatrixXd played = Eigen::MatrixXd::Zero (excitation.ceramics() + 1, excitation.turn);
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
        frequencies[i] = excitation.frequencyOf (excitation.lines[static_cast<std::size_t> (i)]);

    return frequencies;
}
} // namespace antinode
