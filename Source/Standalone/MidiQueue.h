#pragma once

#include <juce_audio_basics/juce_audio_basics.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>

namespace antinode
{
/** Notes on their way from MIDI inputs to the audio thread, which neither locks nor waits; inputs take turns. */
class MidiQueue
{
public:
    static constexpr std::size_t capacity = 1024;

    /** Messages of more than 3 bytes are never notes and are left out.
        @return  false where it was left out, or `capacity` wait already [any but the audio thread] */
    bool push (const juce::MidiMessage&, double milliseconds);

    /** What has come, where it belongs in a block that begins now: a block later than it came, but at even distances.
        @param milliseconds  of the same clock as push() has
        [audio thread] the buffer must have room: see bytesOf */
    void pop (juce::MidiBuffer&, double milliseconds, double sampleRate, int count);

    /** How many bytes a juce::MidiBuffer takes for so many short messages. [any] */
    static constexpr std::size_t bytesOf (std::size_t messages) { return messages * 16; }

private:
    struct Entry
    {
        std::array<std::uint8_t, 3> bytes {};
        int size = 0;
        double milliseconds = 0;
    };

    std::mutex pushing;
    std::array<Entry, capacity> ring {};
    std::atomic<std::size_t> written { 0 }, read { 0 };
};
} // namespace antinode
