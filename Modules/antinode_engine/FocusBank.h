#pragma once

#include "PlayableBrake.h"
#include "VoltageSynthesiser.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace antinode
{
/** A designed focus, ready to play; read-only. */
struct PlayableFocus
{
    /** @throws InputError  as VoltageSynthesiser, and for a free waveform [worker] allocates */
    PlayableFocus (const VoltageProgram&, Playback);

    /** The number of oscillations, brakes included. [any] */
    int oscillationCount() const
    {
        return synthesiser.oscillationCount() + (brake ? brake->designed().oscillationCount() : 0);
    }

    VoltageSynthesiser synthesiser;     ///< Plays everything but the brakes.
    std::int64_t firstSample = 0;       ///< From the trigger: none of these sounds before it,
    std::int64_t endSample = 0;         ///< and none from it on.
    std::optional<PlayableBrake> brake; ///< None if there are no brakes, or more than can be held.

private:
    PlayableFocus (const VoltageProgram&, Playback, bool isBraked);
};

/** The foci of the triggers, each place with a focus or none: 128 places of notes, the one that is edited, and some
   that were touched last. Made on a worker, handed over whole, never changed. */
struct FocusBank
{
    static constexpr int notePlaces = 128;
    static constexpr int livePlace = notePlaces; ///< The focus as it is described, at its own place.
    static constexpr int firstTouchPlace = livePlace + 1;
    static constexpr int touchPlaces = 16;
    static constexpr int places = firstTouchPlace + touchPlaces;

    std::array<std::shared_ptr<const PlayableFocus>, places> foci;

    /** The latest focus of all, in samples after its trigger: the delay that lets every focus fall on its note. [any]
     */
    std::int64_t latestFocusSample() const;
};
} // namespace antinode
