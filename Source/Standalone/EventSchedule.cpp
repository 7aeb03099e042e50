#include "EventSchedule.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_graph/MidiTriggers.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace antinode
{
namespace
{
/** Seconds of a tick where the heading counts frames; none: it counts parts of a quarter note.
    @throws InputError  for a heading that says no time */
std::optional<double> secondsPerTick (const std::string& where, short division)
{
    if (division > 0)
        return {};

    if (division == 0)
        throw InputError (where, "has 0 ticks per quarter note; allowed: 1 to 32767");

    const auto frames = -(division >> 8), ticks = division & 0xff;

    if (ticks == 0)
        throw InputError (where, "has 0 ticks per frame; allowed: 1 to 255");

    if (frames != 24 && frames != 25 && frames != 29 && frames != 30)
        throw InputError (where, "counts " + std::to_string (frames)
                                     + " frames per second; allowed: 24, 25, 29 (29.97, drop frame) or 30");

    return (frames == 29 ? 1001.0 / 30000 : 1.0 / frames) / ticks;
}

void requireTempi (const std::string& where, const juce::MidiFile& midi)
{
    juce::MidiMessageSequence tempi;
    midi.findAllTempoEvents (tempi);

    for (const auto* const tempo : tempi)
        if (! (tempo->message.getTempoSecondsPerQuarterNote() > 0))
            throw InputError (where, "has a tempo of 0 microseconds per quarter note; allowed: 1 or more");
}
} // namespace

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
    int format = 0;

    if (! midi.readFrom (stream, true, &format))
        throw InputError (path.string(), "is not a standard MIDI file");

    if (format == 2)
        throw InputError (path.string(), "has format 2, whose tracks are pieces of their own; allowed: format 0 or 1");

    const auto tick = secondsPerTick (path.string(), midi.getTimeFormat());

    // JUCE counts 29 frames per second where there are 29.97.
    if (! tick)
    {
        requireTempi (path.string(), midi);
        midi.convertTimestampTicksToSeconds();
    }

    std::vector<TimedNote> notes;

    for (int i = 0; i < midi.getNumTracks(); ++i)
        for (const auto* const event : *midi.getTrack (i))
            if (const auto& message = event->message; message.isNoteOnOrOff() || stopsAll (message))
                notes.push_back ({ std::max (0.0, message.getTimeStamp()) * tick.value_or (1), message });

    if (std::none_of (notes.begin(), notes.end(), [] (const auto& note) { return note.message.isNoteOnOrOff(); }))
        throw InputError (path.string(), "contains no notes");

    return notes;
}
} // namespace antinode
