#pragma once

#include "VoltageSynthesiser.h"

#include <array>
#include <cstdint>
#include <memory>

namespace antinode
{
/** A designed focus, ready to be played: read only from here on. */
struct PlayableFocus
{
    /** @throws InputError  as VoltageSynthesiser [worker] allocates */
    PlayableFocus (const VoltageProgram&, Playback);

    VoltageSynthesiser synthesiser;
    std::int64_t firstSample = 0; ///< From the trigger: nothing sounds before it,
    std::int64_t endSample = 0;   ///< and nothing from it on.
};

/** What triggers play, each place with a focus or none: 128 places of notes, the one that is edited, and some that were touched
    last. Made on a worker, handed over whole, never changed. */
struct FocusBank
{
    static constexpr int notePlaces = 128;
    static constexpr int livePlace = notePlaces; ///< The focus as it is described, at its own place.
    static constexpr int firstTouchPlace = livePlace + 1;
    static constexpr int touchPlaces = 16;
    static constexpr int places = firstTouchPlace + touchPlaces;

    std::array<std::shared_ptr<const PlayableFocus>, places> foci;

    /** The latest focus of all, in samples after its trigger: the delay that lets every focus fall on its note. [any] */
    std::int64_t latestFocusSample() const;
};
} // namespace antinode
