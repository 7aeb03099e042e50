#include "FocusBank.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
PlayableFocus::PlayableFocus (const VoltageProgram& program, Playback playback) : synthesiser (program, playback)
{
    auto first = program.focusTime, last = program.focusTime;

    for (const auto& oscillation : program.oscillations)
    {
        first = std::min (first, oscillation.start);
        last = std::max (last, oscillation.end);
    }

    // A sample more on either side: where the focus falls between samples, all is moved by up to half of one.
    firstSample = static_cast<std::int64_t> (std::floor (first * playback.sampleRate)) - 1;
    endSample = static_cast<std::int64_t> (std::ceil (last * playback.sampleRate)) + 2;
}

std::int64_t FocusBank::latestFocusSample() const
{
    std::int64_t latest = 0;

    for (const auto& focus : foci)
        if (focus != nullptr)
            latest = std::max (latest, focus->synthesiser.focusSample());

    return latest;
}
} // namespace antinode
