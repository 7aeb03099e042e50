#include "FocusBank.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace antinode
{
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

    for (const auto& focus : foci)
        if (focus != nullptr)
            latest = std::max ({ latest, focus->endSample, focus->brake ? focus->brake->endSample() : 0 });

    return latest;
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
                                              + " MiB; choose a shorter focus time, a lower sample rate, 'dictionary' "
                                                "instead of 'free_waveform', or notes that play the focus alone");
}
} // namespace antinode
