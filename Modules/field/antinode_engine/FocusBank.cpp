#include "FocusBank.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

namespace antinode
{
namespace
{
constexpr double nothingLeft = 1e-3; // of the slowest mode's amplitude
constexpr double still = 1e-6;       // of a mode's amplitude: brakes end there, and less would come to denormal numbers
constexpr double longestSamples = 1e12; // however slowly a mode decays: sums of such numbers are exact
} // namespace

PlayableBrake::PlayableBrake (const VoltageProgram& brakes, Playback playback)
    : synthesiser (brakes, playback), rate (playback.sampleRate)
{
    auto first = brakes.oscillations.front().start, last = brakes.oscillations.front().end;
    auto slowest = brakes.oscillations.front().freeDecay;

    for (const auto& oscillation : brakes.oscillations)
    {
        first = std::min (first, oscillation.start);
        last = std::max (last, oscillation.end);
        slowest = std::min (slowest, oscillation.freeDecay);
        modes.push_back (toMode (oscillation));
    }

    // The focus is on a sample, the brakes keep their distance to it; a sample within 1e-6 of a step belongs to it.
    const auto position = [&] (double time)
    { return static_cast<double> (synthesiser.focusSample()) + (time - brakes.focusTime) * rate; };
    start = static_cast<std::int64_t> (std::ceil (position (first) - 1e-6));
    end = static_cast<std::int64_t> (std::ceil (position (last))) + 1;
    longest = static_cast<std::int64_t> (std::min (-std::log (nothingLeft) / slowest * rate, longestSamples));
}

PlayableBrake::Mode PlayableBrake::toMode (const Oscillation& brake)
{
    const auto rho = brake.counterShare;
    const auto scale = 1 / (1 - std::norm (rho));
    return { brake.freeDecay, brake.angularFrequency, scale * (1.0 + rho),
             scale * product (rho, 1.0 + std::conj (rho)) };
}

void PlayableBrake::factorsAfter (std::int64_t delay, std::span<std::complex<double>> factors) const
{
    const auto time = static_cast<double> (delay) / rate;

    for (std::size_t c = 0; c < modes.size(); ++c)
    {
        const auto& mode = modes[c];

        // The parts of a mode's brake follow one another.
        if (c > 0 && mode.isAs (modes[c - 1]))
        {
            factors[c] = factors[c - 1];
            continue;
        }

        const auto left = std::exp (-mode.decay * time);
        const auto size = left > still ? left : 0.0;
        const auto phase = mode.frequency * time;
        const std::complex<double> turn { size * std::cos (phase), size * std::sin (phase) };
        factors[c] = product (mode.with, turn) - product (mode.against, std::conj (turn));
    }
}

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

namespace
{
/** The brakes of a program, or all its other oscillations. */
VoltageProgram selectPart (const VoltageProgram& program, bool brakes)
{
    auto part = program;
    std::vector<Eigen::Index> columns;
    part.oscillations.clear();
    part.samples.reset();

    for (std::size_t c = 0; c < program.oscillations.size(); ++c)
        if (program.oscillations[c].isBrake() == brakes)
        {
            part.oscillations.push_back (program.oscillations[c]);
            columns.push_back (static_cast<Eigen::Index> (c));
        }

    part.allocation = program.allocation (Eigen::all, columns);
    return part;
}

bool hasBrake (const VoltageProgram& program)
{
    const auto count = std::count_if (program.oscillations.begin(), program.oscillations.end(),
                                      [] (const Oscillation& oscillation) { return oscillation.isBrake(); });
    return count > 0 && count <= static_cast<std::ptrdiff_t> (PlayableBrake::maximumOscillations);
}
} // namespace

PlayableFocus::PlayableFocus (const VoltageProgram& program, Playback playback)
    : PlayableFocus (program, playback, hasBrake (program))
{
}

PlayableFocus::PlayableFocus (const VoltageProgram& program, Playback playback, bool isBraked)
    : synthesiser (isBraked ? selectPart (program, false) : program, playback)
{
    auto first = program.focusTime, last = program.focusTime;

    for (const auto& oscillation : program.oscillations)
        if (! (isBraked && oscillation.isBrake()))
        {
            first = std::min (first, oscillation.start);
            last = std::max (last, oscillation.end);
        }

    // A sample more on either side: where the focus falls between samples, all is moved by up to half of one.
    firstSample = static_cast<std::int64_t> (std::floor (first * playback.sampleRate)) - 1;
    endSample = static_cast<std::int64_t> (std::ceil (last * playback.sampleRate)) + 2;

    if (isBraked)
        brake.emplace (selectPart (program, true), playback);

    if (program.samples)
    {
        samples.emplace (program, playback, synthesiser.focusSample());
        firstSample = std::min (firstSample, samples->startSample());
        endSample = std::max (endSample, samples->endSample());
    }
}

const PlayableFocus* FocusBank::at (int place) const
{
    if (place < 0 || place >= places + static_cast<int> (prepared.size()))
        return nullptr;

    return place < places ? foci[static_cast<std::size_t> (place)].get()
                          : prepared[static_cast<std::size_t> (place - firstPreparedPlace)].get();
}

std::int64_t FocusBank::latestFocusSample() const
{
    std::int64_t latest = 0;

    for (const auto& focus : foci)
        if (focus != nullptr)
            latest = std::max (latest, focus->synthesiser.focusSample());

    return latest;
}

std::int64_t FocusBank::latestEndSample() const
{
    std::int64_t latest = 0;

    for (auto place = 0; place < places + static_cast<int> (prepared.size()); ++place)
        if (const auto* const focus = at (place))
            latest = std::max ({ latest, focus->endSample, focus->brake ? focus->brake->endSample() : 0 });

    return latest;
}

void requireRoomBeside (const FocusBank& bank, const PlayableFocus& focus)
{
    const auto bytes = std::accumulate (bank.prepared.begin(), bank.prepared.end(), focus.sampleBytes(),
                                        [] (std::size_t sum, const auto& each)
                                        { return sum + (each != nullptr ? each->sampleBytes() : 0); });

    if (bytes > FocusBank::mostSampleBytes)
        throw InputError ("prepared places",
                          "need more than " + std::to_string (FocusBank::mostSampleBytes >> 20U)
                              + " MiB for their samples; choose a shorter focus time, a lower sample "
                                "rate, or the method 'exact'");
}

void requireRoomInBank (const PlayableFocus& focus, std::size_t foci)
{
    constexpr double mebibyte = 1024 * 1024;
    const auto needed = std::ceil (static_cast<double> (focus.sampleBytes()) / mebibyte * static_cast<double> (foci));
    const auto allowed = static_cast<double> (FocusBank::mostSampleBytes) / mebibyte;

    if (needed > allowed)
        throw InputError ("bank of foci", "needs " + std::to_string (std::llround (needed)) + " MiB for the samples of "
                                              + (foci == 1 ? "one place" : std::to_string (foci) + " places")
                                              + "; allowed: " + std::to_string (std::llround (allowed))
                                              + " MiB; choose a shorter focus time, a lower sample rate, 'exact' "
                                                "instead of 'least_voltage', or notes that play the focus alone");
}
} // namespace antinode
