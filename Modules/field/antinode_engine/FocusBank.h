#pragma once

#include "PlayableBrake.h"
#include "PlayableSamples.h"
#include "VoltageSynthesiser.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace antinode
{
/** A designed focus, ready to play; read-only. */
struct PlayableFocus
{
    /** @throws InputError  as VoltageSynthesiser and PlayableSamples [worker] allocates */
    PlayableFocus (const VoltageProgram&, Playback);

    /** The channels that it takes where forces stand apart: its oscillations, brakes included, and for samples the
       ceramics. [any] */
    int forceCount() const
    {
        return synthesiser.oscillationCount() + (brake ? brake->designed().oscillationCount() : 0)
               + (samples ? samples->channelCount() : 0);
    }

    /** Whether it plays anything but samples. [any] */
    bool oscillates() const { return synthesiser.oscillationCount() > 0 || brake; }

    /** What its samples take of the memory. [any] */
    std::size_t sampleBytes() const { return samples ? samples->bytes() : 0; }

    VoltageSynthesiser synthesiser;         ///< Plays all oscillations but the brakes.
    std::optional<PlayableSamples> samples; ///< Of a free waveform.
    std::int64_t firstSample = 0;           ///< From the trigger: none of these sounds before it,
    std::int64_t endSample = 0;             ///< and none from it on.
    std::optional<PlayableBrake> brake;     ///< None if there are no brakes, or more than can be held.

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
    static constexpr std::size_t mostSampleBytes = 256U << 20U; ///< Of all places together.

    std::array<std::shared_ptr<const PlayableFocus>, places> foci;

    /** The latest focus of all, in samples after its trigger: the delay that lets every focus fall on its note. [any]
     */
    std::int64_t latestFocusSample() const;

    /** The first sample after a trigger from which on no focus sounds, its brake included. [any] */
    std::int64_t latestEndSample() const;
};

/** Whether a bank has room for as many foci like this one.
    @throws InputError  where their samples would take more than mostSampleBytes
    [any] */
void requireRoomInBank (const PlayableFocus&, std::size_t foci);
} // namespace antinode
