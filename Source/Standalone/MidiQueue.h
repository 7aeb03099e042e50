#pragma once

#include <antinode_base/RingQueue.h>
#include <antinode_session/StopCount.h>

#include <juce_audio_basics/juce_audio_basics.h>

#include <array>
#include <cstdint>
#include <mutex>

namespace antinode
{
/** Notes on their way from MIDI inputs to the audio thread, which neither locks nor waits; inputs are serialised. A
   stop voids those that wait. */
class MidiQueue
{
public:
    static constexpr std::size_t capacity = 1024;

    /** @param stopsToCount  of what plays the notes; outlives this */
    explicit MidiQueue (StopCount& stopsToCount) : stopCount (stopsToCount) {}

    /** [any] */
    const StopCount& stops() const { return stopCount; }

    /** Messages of more than 3 bytes are never notes and are left out. All notes off stops even where there is no room.
        @return  false where it was left out, or `capacity` wait already [any but the audio thread] */
    bool push (const juce::MidiMessage&, double milliseconds);

    /** The received messages at their samples in a block that starts now: one block late, but with their original
       spacing.
        @param milliseconds  of the same clock as push() has
        [audio thread] the buffer must have room: see bytesNeeded */
    void pop (juce::MidiBuffer&, double milliseconds, double sampleRate, int count);

    /** The number of bytes of a juce::MidiBuffer for the given number of short messages. [any] */
    static constexpr std::size_t bytesNeeded (std::size_t messages) { return messages * 16; }

private:
    struct Entry
    {
        std::array<std::uint8_t, 3> bytes {};
        int size = 0;
        double milliseconds = 0;
        std::uint64_t askedAt = 0; ///< StopCount::now() then.
    };

    StopCount& stopCount;
    std::mutex pushing;
    RingQueue<Entry, capacity> waiting;
};
} // namespace antinode
