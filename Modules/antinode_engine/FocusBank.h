#pragma once

#include "PlayableBrake.h"
#include "VoltageSynthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace antinode
{
/** A designed focus, ready to be played: read only from here on. */
struct PlayableFocus
{
    /** @throws InputError  as VoltageSynthesiser [worker] allocates */
    PlayableFocus (const VoltageProgram&, Playback);

    VoltageSynthesiser synthesiser;     ///< Of all but the brakes.
    std::int64_t firstSample = 0;       ///< From the trigger: none of these sounds before it,
    std::int64_t endSample = 0;         ///< and none from it on.
    std::optional<PlayableBrake> brake; ///< None where there are no brakes, or more than can be held.

private:
    PlayableFocus (const VoltageProgram&, Playback, bool isBraked);
};

/** What the notes play: 128 places, each with a focus or none. Made on a worker, handed over whole, never changed. */
struct FocusBank
{
    static constexpr int places = 128;

    std::array<std::shared_ptr<const PlayableFocus>, places> foci;

    /** The latest focus of all, in samples after its trigger: the delay that lets every focus fall on its note. [any] */
    std::int64_t latestFocusSample() const;
};
} // namespace antinode
