#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <variant>

namespace antinode
{
/** Frequencies from a lower to an upper one, Hz. */
struct TrackBand
{
    double lower = 40, upper = 1000;
};

/** Ricker's wavelet, the shortest pulse without offset. */
struct ClickSignal
{
    double frequency = 250; ///< Of the largest line of its spectrum, Hz.
};

/** A tone under a Gaussian envelope. */
struct GaborSignal
{
    double frequency = 200; ///< Hz
    double width = 0.02;    ///< Of the envelope at half of its height, s.
};

/** A tone that rises and falls as a raised cosine; with a modulation, its amplitude swings. */
struct ToneSignal
{
    double frequency = 250;         ///< Hz
    double duration = 0.3;          ///< s
    double attack = 0.02;           ///< Of rise and fall each, s.
    double modulationFrequency = 0; ///< Hz; 0: none.
    double modulationDepth = 1;     ///< 0 to 1: the share by which the amplitude falls.
};

/** Noise of even power within the band, which rises and falls as a tone does. */
struct NoiseSignal
{
    double duration = 0.3;  ///< s
    double attack = 0.02;   ///< s
    std::uint64_t seed = 1; ///< Another seed, another noise; the same on every computer.
};

/** A recording. What lies outside the band is removed, 5 ms at both ends are faded. */
struct SampledSignal
{
    std::string source;      ///< The file's name.
    double sampleRate = 0;   ///< Hz
    Eigen::VectorXd samples; ///< Any unit.
};

using TrackSignal = std::variant<ClickSignal, GaborSignal, ToneSignal, NoiseSignal, SampledSignal>;

/** How long a signal lasts, s. [any] */
double signalDuration (const TrackSignal&);

/** A signal from its begin to its end at a rate, in no unit: 0 before and after.
    @param sampleRate  Hz, at least 3 times the band's upper frequency
    @return            N_s samples, the last one not before the signal's end
    [worker] Docs/Theory.md, section 4.13. */
Eigen::VectorXd signalSamples (const TrackSignal&, TrackBand, double sampleRate);
} // namespace antinode
