#include "MidiNotes.h"

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

bool MidiQueue::push (const juce::MidiMessage& message, double milliseconds)
{
    const auto size = message.getRawDataSize();

    if (size < 1 || size > 3)
        return false;

    Entry entry { {}, size, milliseconds, stopCount.now() };
    std::copy_n (message.getRawData(), size, entry.bytes.begin());
    const std::lock_guard lock (pushing);
    const auto isTaken = waiting.push (entry);

    if (! isTaken && stopsAll (message))
        stopCount.stopByNote();

    return isTaken;
}

void MidiQueue::pop (juce::MidiBuffer& buffer, double milliseconds, double sampleRate, int count)
{
    // No more than wait now: the buffer has no room for what comes meanwhile, and stops that these wait behind are
    // seen.
    auto left = waiting.size();

    for (const auto stop = stopCount.now(); left > 0; --left)
    {
        const auto entry = waiting.pop().value();

        if (entry.askedAt != stop)
            continue;

        const auto age = (milliseconds - entry.milliseconds) * sampleRate / 1000;
        const auto offset = std::clamp (count - age, 0.0, std::max (0, count - 1) * 1.0);
        buffer.addEvent (entry.bytes.data(), entry.size, static_cast<int> (offset));
    }
}

namespace
{
constexpr int lookMilliseconds = 2000;
}

MidiInputs::MidiInputs (MidiQueue& queueToFill) : queue (queueToFill) {}

MidiInputs::~MidiInputs()
{
    stopTimer();
}

void MidiInputs::choose (const MidiChoice& wanted)
{
    chosen = wanted;
    update();
    startTimer (lookMilliseconds);
}

void MidiInputs::update()
{
    const auto devices = available();
    const auto isWanted = [&] (const juce::String& identifier)
    {
        const auto isThere = std::any_of (devices.begin(), devices.end(),
                                          [&] (const auto& device) { return device.identifier == identifier; });
        const auto& names = chosen.inputs;
        return isThere
               && (chosen.all || std::find (names.begin(), names.end(), identifier.toStdString()) != names.end());
    };
    refused.clear();
    missing = chosen.all
                  ? 0
                  : static_cast<int> (std::count_if (chosen.inputs.begin(), chosen.inputs.end(),
                                                     [&] (const auto& wanted)
                                                     { return ! isWanted (juce::String::fromUTF8 (wanted.c_str())); }));
    std::erase_if (inputs, [&] (const auto& input) { return ! isWanted (input->getIdentifier()); });

    for (const auto& device : devices)
    {
        const auto isOpen =
            std::any_of (inputs.begin(), inputs.end(),
                         [&] (const auto& input) { return input->getIdentifier() == device.identifier; });

        if (isOpen || ! isWanted (device.identifier))
            continue;

        if (auto input = juce::MidiInput::openDevice (device.identifier, this))
        {
            input->start();
            inputs.push_back (std::move (input));
        }
        else
            refused.push_back (device.name.toStdString());
    }
}

std::vector<UserMessage> MidiInputs::messages() const
{
    std::vector<UserMessage> messages;

    for (const auto& name : refused)
        addMessage (messages, Urgency::caution,
                    "MIDI input '" + name + "': cannot be opened; close the program that uses it");

    if (missing > 0)
        addMessage (messages, Urgency::caution,
                    std::to_string (missing) + (missing == 1 ? " chosen MIDI input is" : " chosen MIDI inputs are")
                        + " not plugged in. Plug it in, or choose others in Settings, MIDI.");

    return messages;
}

void MidiInputs::handleIncomingMidiMessage (juce::MidiInput*, const juce::MidiMessage& message)
{
    queue.push (message, message.getTimeStamp() * 1000);
}
} // namespace antinode
