#include "PlayableSamples.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace antinode
{
namespace
{
std::string rateInWords (Playback playback)
{
    std::ostringstream stream;
    stream.precision (9); // 2000000 instead of 2e+06
    stream << playback.sampleRate << " Hz";
    return stream.str();
}

std::string playbackInWords (Playback playback)
{
    return rateInWords (playback) + ", "
           + (playback.reconstruction == Reconstruction::bandLimited ? "band_limited" : "zero_order_hold");
}
} // namespace

std::int64_t firstOwnSample (const VoltageProgram& program, Playback playback, std::int64_t focusSample)
{
    const auto& samples = program.samples.value();
    const auto made = samples.playback;

    if (made.sampleRate != playback.sampleRate || made.reconstruction != playback.reconstruction)
        throw InputError ("sample rate", "is " + playbackInWords (playback)
                                             + ", but this free waveform was designed for " + playbackInWords (made)
                                             + "; design it again for " + rateInWords (playback));

    if (samples.values.rows() != program.voltageLimits.size())
        throw InputError ("voltage program", "needs samples for every ceramic of the device");

    return focusSample + std::llround ((samples.firstTime - program.focusTime) * made.sampleRate);
}

PlayableSamples::PlayableSamples (const VoltageProgram& program, Playback playback, std::int64_t focusSample)
    : start (firstOwnSample (program, playback, focusSample))
{
    const auto& values = program.samples->values;

    if (! values.allFinite())
        throw InputError ("voltage program", "has a sample that is not finite");

    end = start + values.cols();
    samples = PlanarBuffer<float> (static_cast<int> (values.rows()), static_cast<int> (values.cols()));

    for (Eigen::Index i = 0; i < values.rows(); ++i)
        for (Eigen::Index n = 0; n < values.cols(); ++n)
            samples.channel (static_cast<std::size_t> (i))[n] = static_cast<float> (values (i, n));
}

void PlayableSamples::add (std::int64_t first, int count, double amplitude, double* const* channels,
                           std::ptrdiff_t offset) const
{
    const auto from = std::max (first, start), to = std::min (first + count, end);

    if (from >= to)
        return;

    for (std::size_t i = 0; i < samples.size(); ++i)
        kernel.addScaled (samples.channel (i) + (from - start), amplitude, channels[i] + offset + (from - first),
                          static_cast<int> (to - from));
}

void PlayableSamples::addFaded (std::int64_t first, int count, double amplitude, const double* gains,
                                double* const* channels) const
{
    const auto from = std::max (first, start), to = std::min (first + count, end);

    if (from >= to)
        return;

    for (std::size_t i = 0; i < samples.size(); ++i)
        kernel.addFaded (samples.channel (i) + (from - start), gains + (from - first), amplitude,
                         channels[i] + (from - first), static_cast<int> (to - from));
}
} // namespace antinode
