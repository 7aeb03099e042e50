#include "Excitation.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
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

namespace
{
constexpr int clippings = 40;
constexpr double firstClip = 0.7, lastClip = 0.9; // of the peak
constexpr Eigen::Index oversampling = 2;          // Clipped samples alone leave the peaks between them.

Eigen::VectorXcd schroederSpectrum (const std::vector<Eigen::Index>& lines, Eigen::Index length)
{
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (length / 2 + 1);
    const auto count = static_cast<double> (lines.size());
    double n = 0;

    for (const auto line : lines)
    {
        n += 1;
        spectrum[line] = std::polar (1.0, -std::numbers::pi * std::fmod (n * (n - 1) / count, 2.0));
    }

    return spectrum;
}

/** The waveform between the samples, too: oversampled. */
Eigen::VectorXd oversampledWaveform (const Eigen::VectorXcd& spectrum, Eigen::Index length)
{
    Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (oversampling * length / 2 + 1);
    wide.head (spectrum.size()) = spectrum;
    return inverseFourier (wide, oversampling * length);
}

/** The same lines with equal amplitudes and the phases of a waveform. */
Eigen::VectorXcd withPhasesFrom (const Eigen::VectorXd& waveform, const std::vector<Eigen::Index>& lines,
                                 Eigen::Index count)
{
    const auto phases = forwardFourier (waveform);
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (count);

    for (const auto line : lines)
        spectrum[line] = std::polar (1.0, std::arg (phases[line]));

    return spectrum;
}
} // namespace

std::vector<Eigen::Index> everyLine (Eigen::Index lowest, Eigen::Index highest)
{
    std::vector<Eigen::Index> lines;

    for (auto line = lowest; line <= highest; ++line)
        lines.push_back (line);

    return lines;
}

std::vector<Eigen::Index> oddRandomLines (Eigen::Index lowest, Eigen::Index highest, std::uint64_t seed)
{
    constexpr Eigen::Index group = 4;
    RandomNumbers random (seed);
    std::vector<Eigen::Index> lines;
    Eigen::Index place = 0, leftOut = 0;

    for (auto line = lowest | 1; line <= highest; line += 2, place = (place + 1) % group)
    {
        if (place == 0)
            leftOut = static_cast<Eigen::Index> (static_cast<double> (group) * random.uniform());

        if (place != leftOut)
            lines.push_back (line);
    }

    if (lines.empty())
        throw InputError ("excitation", "has no odd line in its band; choose a wider band or a finer resolution");

    return lines;
}

Eigen::VectorXd multisinePeriod (const std::vector<Eigen::Index>& lines, Eigen::Index length)
{
    auto spectrum = schroederSpectrum (lines, length);
    auto best = spectrum;
    auto waveform = oversampledWaveform (spectrum, length);
    auto lowest = waveform.cwiseAbs().maxCoeff();

    for (int i = 0; i < clippings; ++i)
    {
        const auto share = firstClip + (lastClip - firstClip) * i / (clippings - 1);
        const auto clip = share * waveform.cwiseAbs().maxCoeff();
        spectrum = withPhasesFrom (waveform.cwiseMax (-clip).cwiseMin (clip), lines, spectrum.size());
        waveform = oversampledWaveform (spectrum, length);

        // All have the same effective value, so the lowest peak has the lowest crest factor.
        if (const auto peak = waveform.cwiseAbs().maxCoeff(); peak < lowest)
        {
            lowest = peak;
            best = spectrum;
        }
    }

    const auto signal = inverseFourier (best, length);
    return signal / signal.cwiseAbs().maxCoeff();
}

namespace
{
constexpr double below = 0.8, above = 1.15, nearNyquist = 0.49;

/** Half a period of a cosine from 0 to 1. */
double fade (double place)
{
    return 0.5 - 0.5 * std::cos (std::numbers::pi * std::clamp (place, 0.0, 1.0));
}
} // namespace

Sweep makeSweep (double lowestFrequency, double highestFrequency, double duration, double sampleRate)
{
    Sweep sweep;
    sweep.startFrequency = below * lowestFrequency;
    sweep.endFrequency = std::min (above * highestFrequency, nearNyquist * sampleRate);
    const auto octaves = std::log (sweep.endFrequency / sweep.startFrequency);
    const auto turns = std::max (1.0, std::round (sweep.startFrequency * duration / octaves)); // f_1 L
    sweep.rise = turns / sweep.startFrequency;

    const auto fadeIn = sweep.rise * std::log (1 / below);
    const auto fadeOut = sweep.rise * std::log (sweep.endFrequency / highestFrequency);
    const auto length = sweep.rise * octaves;
    sweep.samples.resize (static_cast<Eigen::Index> (length * sampleRate) + 1);

    for (Eigen::Index n = 0; n < sweep.samples.size(); ++n)
    {
        const auto t = static_cast<double> (n) / sampleRate;
        const auto phase = turns * std::expm1 (t / sweep.rise); // in turns
        sweep.samples[n] = std::sin (2 * std::numbers::pi * std::remainder (phase, 1.0)) * fade (t / fadeIn)
                           * fade ((length - t) / fadeOut);
    }

    return sweep;
}
} // namespace antinode
