#pragma once

#include <juce_audio_basics/juce_audio_basics.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace antinode
{
/** A note that is played at its time. */
struct TimedNote
{
    double seconds = 0; ///< After the start, 0 or more.
    juce::MidiMessage message;
};

/** Notes that are known beforehand, played to the sample. */
class EventSchedule
{
public:
    EventSchedule() = default;

    /** Notes of the same time stay in their order. [worker] */
    explicit EventSchedule (std::vector<TimedNote> notesToPlay);

    /** Adds those of a block, at their samples in it; blocks must follow each other.
        @param start  of the block, samples since the start
        [audio thread] where the buffer has room */
    void addTo (juce::MidiBuffer&, std::int64_t start, int count, double sampleRate);

    /** Back to its beginning. [audio thread] */
    void rewind() { next = 0; }

    /** As if all had been played. [audio thread] */
    void end() { next = notes.size(); }

    std::size_t size() const { return notes.size(); }

    /** The numbers of the notes that begin, each once, in the order in which they first do. [any] */
    std::vector<int> noteNumbers() const;

private:
    std::vector<TimedNote> notes;
    std::size_t next = 0;
};

/** The notes of all tracks of a standard MIDI file, and what stops them, with its changes of tempo.
    @throws InputError  when it cannot be read, is no MIDI file, has no notes or a heading or tempo that says no time
    [worker] */
std::vector<TimedNote> readMidiFile (const std::filesystem::path&);
} // namespace antinode
