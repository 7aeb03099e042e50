#include "TrackSignal.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
constexpr auto pi = std::numbers::pi;
constexpr double clickReach = 4;   // pi f t at the ends of a click: there it has fallen to 1e-6
constexpr double gaborReach = 2.2; // widths from the middle of a Gabor burst to its ends: the same
constexpr double edgeFade = 0.005; // s at both ends of a recording
constexpr double lowSlope = 0.8;   // of the lower frequency: where its slope begins
constexpr double highSlope = 1.15; // of the upper frequency: where its slope ends

/** From 0 to 1 along a raised cosine. */
double raised (double share)
{
    return 0.5 - 0.5 * std::cos (pi * std::clamp (share, 0.0, 1.0));
}

/** Rises and falls within an attack. */
double envelope (double time, double duration, double attack)
{
    return attack > 0 ? raised (time / attack) * raised ((duration - time) / attack) : 1;
}

double durationOf (const ClickSignal& click)
{
    return 2 * clickReach / (pi * click.frequency);
}

double durationOf (const GaborSignal& gabor)
{
    return 2 * gaborReach * gabor.width;
}

double durationOf (const ToneSignal& tone)
{
    return tone.duration;
}

double durationOf (const NoiseSignal& noise)
{
    return noise.duration;
}

double durationOf (const SampledSignal& sampled)
{
    return static_cast<double> (sampled.samples.size() - 1) / sampled.sampleRate;
}

double valueAt (const ClickSignal& click, double time)
{
    const auto angle = std::pow (pi * click.frequency * time - clickReach, 2);
    return (1 - 2 * angle) * std::exp (-angle);
}

double valueAt (const GaborSignal& gabor, double time)
{
    const auto fromMiddle = time - gaborReach * gabor.width;
    return std::exp (-4 * std::numbers::ln2 * std::pow (fromMiddle / gabor.width, 2))
           * std::cos (2 * pi * gabor.frequency * fromMiddle);
}

double valueAt (const ToneSignal& tone, double time)
{
    const auto swing = 0.5 + 0.5 * std::cos (2 * pi * tone.modulationFrequency * time);
    const auto amplitude = tone.modulationFrequency > 0 ? 1 - tone.modulationDepth * swing : 1;
    return envelope (time, tone.duration, tone.attack) * amplitude * std::sin (2 * pi * tone.frequency * time);
}

template <typename Signal>
Eigen::VectorXd sampled (const Signal& signal, TrackBand, double sampleRate, Eigen::VectorXd samples)
{
    for (Eigen::Index n = 0; n < samples.size(); ++n)
        if (const auto time = static_cast<double> (n) / sampleRate; time <= durationOf (signal))
            samples[n] = valueAt (signal, time);

    return samples;
}

/** Tones of equal amplitude and random phase, as many as have a whole number of periods. */
Eigen::VectorXd sampled (const NoiseSignal& noise, TrackBand band, double sampleRate, Eigen::VectorXd samples)
{
    RandomNumbers random (noise.seed);
    const auto first = static_cast<std::int64_t> (std::ceil (band.lower * noise.duration));
    const auto last = static_cast<std::int64_t> (std::floor (band.upper * noise.duration));

    for (auto line = first; line <= last; ++line)
    {
        checkWatch();
        const auto turn = std::polar (1.0, 2 * pi * static_cast<double> (line) / (noise.duration * sampleRate));
        auto phasor = std::polar (1.0, 2 * pi * random.uniform());

        for (auto& value : samples)
        {
            value += phasor.real();
            phasor *= turn;
        }
    }

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] *= envelope (static_cast<double> (n) / sampleRate, noise.duration, noise.attack);

    return samples;
}

/** What is in the band, without a shift in time. */
Eigen::VectorXd withinBand (const Eigen::VectorXd& samples, TrackBand band, double sampleRate)
{
    constexpr double silence = 0.1; // s, in which the filter dies away
    const auto length = quickLength (static_cast<double> (samples.size()) + silence * sampleRate);
    auto spectrum = forwardFourier (samples, length);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
    {
        const auto frequency = static_cast<double> (k) * sampleRate / static_cast<double> (length);
        spectrum[k] *= raised ((frequency / band.lower - lowSlope) / (1 - lowSlope))
                       * raised ((highSlope - frequency / band.upper) / (highSlope - 1));
    }

    return inverseFourier (spectrum, length).head (samples.size());
}

/** At another rate: the interpolation reaches so far that nothing above either Nyquist frequency is left. */
Eigen::VectorXd sampled (const SampledSignal& signal, TrackBand band, double sampleRate, Eigen::VectorXd samples)
{
    const auto ratio = signal.sampleRate / sampleRate, width = std::max (1.0, ratio);
    const auto reach = kaiserSincHalfWidth * width;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
    {
        const auto centre = static_cast<double> (n) * ratio;
        const auto begin = std::max<Eigen::Index> (0, static_cast<Eigen::Index> (std::ceil (centre - reach)));
        const auto end = std::min (signal.samples.size(), static_cast<Eigen::Index> (std::floor (centre + reach)) + 1);

        for (auto m = begin; m < end; ++m)
            samples[n] += signal.samples[m] * kaiserSinc ((centre - static_cast<double> (m)) / width) / width;
    }

    samples = withinBand (samples, band, sampleRate);

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] *= envelope (static_cast<double> (n) / sampleRate, durationOf (signal), edgeFade);

    return samples;
}
} // namespace

double signalDuration (const TrackSignal& signal)
{
    return std::visit ([] (const auto& each) { return durationOf (each); }, signal);
}

Eigen::VectorXd signalSamples (const TrackSignal& signal, TrackBand band, double sampleRate)
{
    constexpr double rounding = 1e-9; // samples
    const auto count = static_cast<Eigen::Index> (std::ceil (signalDuration (signal) * sampleRate - rounding)) + 1;
    return std::visit (
        [&] (const auto& each) { return sampled (each, band, sampleRate, Eigen::VectorXd::Zero (count)); }, signal);
}
} // namespace antinode
