#include "WantedMotion.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_fingers/FeltDisplacement.h>
#include <antinode_fingers/FeltMotion.h>
#include <antinode_numerics/Fourier.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
/** The largest velocity of a displacement, between samples too, m/s. */
double largestVelocityOf (const Eigen::VectorXd& displacement, double sampleRate)
{
    const auto length = quickLength (2 * static_cast<double> (displacement.size()));
    auto spectrum = forwardFourier (displacement, length);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        spectrum[k] *= std::complex (0.0, 2 * std::numbers::pi * static_cast<double> (k) * sampleRate
                                              / static_cast<double> (length));

    return peakBetweenSamples (inverseFourier (spectrum, length));
}

void requireInBand (const WaveformsDescription& description, std::size_t track)
{
    const auto check = [&] (const auto& signal)
    {
        if constexpr (requires { signal.frequency; })
            if (! (signal.frequency >= description.band.lower && signal.frequency <= description.band.upper))
                throw InputError ("waveforms: " + pointInWords (description, track) + " frequency",
                                  "is " + inWords (signal.frequency) + " Hz; allowed: the band, "
                                      + inWords (description.band.lower) + " to " + inWords (description.band.upper)
                                      + " Hz");
    };
    std::visit (check, description.tracks[track].signal);
}

/** What to multiply a waveform by so that it has its level. */
double scaleFor (const Eigen::VectorXd& waveform, double sampleRate, const TrackLevel& level,
                 const SkinThreshold& threshold)
{
    switch (level.kind)
    {
        case LevelKind::velocity:
            return level.value / largestVelocityOf (waveform, sampleRate);
        case LevelKind::sensation:
            return std::pow (10, level.value / 20)
                   / feltAmount (feltDisplacement (waveform, sampleRate, threshold), sampleRate);
        case LevelKind::displacement:
            break;
    }

    return level.value / peakBetweenSamples (waveform);
}
} // namespace

Eigen::MatrixXd wantedMotion (const WaveformsDescription& description, const SkinThreshold& threshold,
                              double sampleRate)
{
    const auto points = description.tracks.size() + description.silent.size();
    const auto samples = static_cast<Eigen::Index> (std::ceil (tracksDuration (description) * sampleRate)) + 1;
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero (samples, static_cast<Eigen::Index> (points));

    for (std::size_t p = 0; p < description.tracks.size(); ++p)
    {
        requireInBand (description, p);
        const auto& track = description.tracks[p];
        const auto first = std::llround (track.start * sampleRate);
        const auto waveform = signalSamples (track.signal, description.band, sampleRate);

        if (! (waveform.cwiseAbs().maxCoeff() > 0))
            throw InputError ("waveforms: " + pointInWords (description, p), "is silent within the band");

        const auto count = std::min<Eigen::Index> (waveform.size(), samples - first);
        motion.col (static_cast<Eigen::Index> (p)).segment (first, count) =
            scaleFor (waveform, sampleRate, track.level, threshold) * waveform.head (count);
    }

    return motion;
}
} // namespace antinode
