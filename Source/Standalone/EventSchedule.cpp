#include "EventSchedule.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
EventSchedule::EventSchedule (std::vector<TimedNote> notesToPlay) : notes (std::move (notesToPlay))
{
    std::stable_sort (notes.begin(), notes.end(),
                      [] (const auto& one, const auto& other) { return one.seconds < other.seconds; });
}

void EventSchedule::addTo (juce::MidiBuffer& buffer, std::int64_t start, int count, double sampleRate)
{
    for (; next < notes.size(); ++next)
    {
        const auto offset = std::llround (notes[next].seconds * sampleRate) - start;

        if (offset >= count)
            return;

        buffer.addEvent (notes[next].message, static_cast<int> (std::max<std::int64_t> (0, offset)));
    }
}

std::vector<int> EventSchedule::noteNumbers() const
{
    std::vector<int> numbers;

    for (const auto& note : notes)
        if (const auto number = note.message.getNoteNumber();
            note.message.isNoteOn() && std::find (numbers.begin(), numbers.end(), number) == numbers.end())
            numbers.push_back (number);

    return numbers;
}

std::vector<TimedNote> readMidiFile (const std::filesystem::path& path)
{
    const auto bytes = readWholeFile (path, { "a MIDI file", FileKind().maximumBytes, "cannot be opened" });
    juce::MemoryInputStream stream (bytes.data(), bytes.size(), false);
    juce::MidiFile midi;

    if (! midi.readFrom (stream))
        throw InputError (path.string(), "is not a standard MIDI file");

    midi.convertTimestampTicksToSeconds();
    std::vector<TimedNote> notes;

    for (int i = 0; i < midi.getNumTracks(); ++i)
        for (const auto* const event : *midi.getTrack (i))
            if (const auto& message = event->message; message.isNoteOnOrOff())
                notes.push_back ({ std::max (0.0, message.getTimeStamp()), message });

    if (notes.empty())
        throw InputError (path.string(), "contains no notes");

    return notes;
}
} // namespace antinode
