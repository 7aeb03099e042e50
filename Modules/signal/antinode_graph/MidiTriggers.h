#pragma once

#include <antinode_engine/FocusEvents.h>

#include <juce_audio_basics/juce_audio_basics.h>

#include <array>
#include <span>

namespace antinode
{
/** Whether a message ends all that sounds: all sound off, all notes off and the changes of mode that imply it, system
    reset. [any] Source: MIDI 1.0 Detailed Specification, channel mode messages 120 and 123 to 127, and FF. */
bool stopsAll (const juce::MidiMessage&);

/** MIDI as focus events: note number = place, velocity / 127 = amplitude, on every channel; what ends all that sounds
 * stops everything. */
class MidiTriggers
{
public:
    static constexpr std::size_t mostEvents = 1024; ///< Of a block; those beyond are left out.

    /** The events of a block, in the order of their samples. No stop is left out.
        @return  valid until the next call
        [audio thread] allocates nothing, locks nothing */
    std::span<const FocusEvent> read (const juce::MidiBuffer&, int blockLength);

private:
    std::array<FocusEvent, mostEvents> events;
};
} // namespace antinode
