#include <Standalone/MidiNotes.h>

#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace antinode;

namespace
{
juce::MidiMessage note (int number)
{
    return juce::MidiMessage::noteOn (1, number, juce::uint8 (100));
}

/** Sample and note of all events, where blocks have these lengths in turn. */
std::vector<std::pair<int, int>> played (EventSchedule schedule, int samples, const std::vector<int>& blocks)
{
    std::vector<std::pair<int, int>> events;
    std::size_t next = 0;

    for (int start = 0, count = 0; start < samples; start += count)
    {
        count = blocks[next++ % blocks.size()];
        juce::MidiBuffer buffer;
        schedule.addTo (buffer, start, count, 48000);

        for (const auto event : buffer)
        {
            CHECK ((event.samplePosition >= 0 && event.samplePosition < count));
            events.emplace_back (start + event.samplePosition, event.getMessage().getNoteNumber());
        }
    }

    return events;
}
} // namespace

TEST_CASE ("notes of a schedule fall on their samples, whatever the blocks")
{
    const EventSchedule schedule (
        { { 0.01, note (62) }, { 0, note (60) }, { 0.01, note (63) }, { 0.0199999, note (64) } });
    const std::vector<std::pair<int, int>> wanted { { 0, 60 }, { 480, 62 }, { 480, 63 }, { 960, 64 } };

    for (const auto& blocks : std::vector<std::vector<int>> { { 4096 }, { 1 }, { 480 }, { 256 }, { 961, 3 } })
        CHECK (played (schedule, 4096, blocks) == wanted);
}

TEST_CASE ("a schedule's notes are counted once, in the order in which they begin")
{
    const EventSchedule schedule ({ { 3, note (60) },
                                    { 1, juce::MidiMessage::noteOff (1, 50) },
                                    { 2, note (64) },
                                    { 4, note (64) },
                                    { 2, note (62) } });
    CHECK (schedule.noteNumbers() == std::vector { 64, 62, 60 });
    CHECK (EventSchedule().noteNumbers().empty());
}

TEST_CASE ("a MIDI file's notes fall where its tempi say")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "notes.mid";
    juce::MidiMessageSequence tempi, notes;
    tempi.addEvent (juce::MidiMessage::tempoMetaEvent (500000), 0);   // 120 quarters a minute
    tempi.addEvent (juce::MidiMessage::tempoMetaEvent (250000), 960); // and 240 from the second one on
    notes.addEvent (note (60), 0);
    notes.addEvent (note (61), 960);
    notes.addEvent (note (62), 1920);
    juce::MidiFile file;
    file.setTicksPerQuarterNote (960);
    file.addTrack (tempi);
    file.addTrack (notes);
    {
        juce::FileOutputStream stream { juce::File (path.string()) };
        REQUIRE (file.writeTo (stream));
    }
    CHECK (played (EventSchedule (readMidiFile (path)), 40000, { 333 })
           == std::vector<std::pair<int, int>> { { 0, 60 }, { 24000, 61 }, { 36000, 62 } });
}

namespace
{
/** A file of one track: a tempo, and notes 60 at 0 and 61 after so many ticks. */
std::string midiFile (int format, int division, int tempo, int ticks)
{
    std::string track ("\0\xFF\x51\3", 4);

    for (const auto shift : { 16, 8, 0 })
        track += static_cast<char> (tempo >> shift & 255);

    track += std::string ("\0\x90\x3C\x64", 4);

    for (const auto shift : { 21, 14, 7 })
        track += static_cast<char> ((ticks >> shift & 127) | 128);

    track += static_cast<char> (ticks & 127);
    track += std::string ("\x90\x3D\x64\0\xFF\x2F\0", 7);
    std::string file ("MThd\0\0\0\6\0", 9);
    file += static_cast<char> (format);
    file += std::string ("\0\1", 2);
    file += static_cast<char> (division >> 8 & 255);
    file += static_cast<char> (division & 255);
    file += std::string ("MTrk\0\0\0", 7);
    file += static_cast<char> (track.size());
    return file + track;
}

int framesWith (int frames, int ticks)
{
    return (256 - frames) << 8 | ticks;
}
} // namespace

TEST_CASE ("a MIDI file that counts frames has a second where its rate says")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "frames.mid";
    const auto secondNote = [&] (int division, int ticks)
    {
        std::ofstream (path, std::ios::binary) << midiFile (1, division, 250000, ticks);
        const auto notes = readMidiFile (path);
        REQUIRE (notes.size() == 2);
        CHECK (notes[0].seconds == 0);
        return notes[1].seconds;
    };
    CHECK (secondNote (framesWith (24, 80), 24 * 80) == Approx (1).epsilon (1e-14));
    CHECK (secondNote (framesWith (25, 40), 25 * 40) == Approx (1).epsilon (1e-14));
    CHECK (secondNote (framesWith (30, 255), 30 * 255) == Approx (1).epsilon (1e-14));
    CHECK (secondNote (framesWith (29, 1), 30000) == Approx (1001).epsilon (1e-14)); // 30000 / 1001 per second
    CHECK (secondNote (framesWith (29, 100), 2997) == Approx (0.999999).epsilon (1e-14));
    CHECK (secondNote (960, 960) == Approx (0.25).epsilon (1e-14));
    CHECK (secondNote (32767, 32767) == Approx (0.25).epsilon (1e-14));
}

TEST_CASE ("a MIDI file whose times are none is an error in a sentence")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "timeless.mid";
    const auto refusal = [&] (const std::string& bytes)
    {
        std::ofstream (path, std::ios::binary) << bytes;
        return errorText ([&] { readMidiFile (path); });
    };
    const auto where = path.string() + ": ";
    CHECK (refusal (midiFile (1, 0, 500000, 960)) == where + "has 0 ticks per quarter note; allowed: 1 to 32767");
    CHECK (refusal (midiFile (1, framesWith (25, 0), 500000, 960))
           == where + "has 0 ticks per frame; allowed: 1 to 255");
    CHECK (refusal (midiFile (1, framesWith (60, 4), 500000, 960)).find (where + "counts 60 frames per second") == 0);
    CHECK (refusal (midiFile (1, 960, 0, 960)).find (where + "has a tempo of 0") == 0);
    CHECK (refusal (midiFile (2, 960, 500000, 960)).find (where + "has format 2") == 0);
    CHECK (refusal (midiFile (0, 960, 500000, 960)).empty());
}

TEST_CASE ("a file that is no MIDI file is an error in a sentence")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "text.mid";
    CHECK (errorText ([&] { readMidiFile (path); }) == path.string() + ": cannot be opened");
    std::ofstream (path) << "MThd and then nothing of the kind";
    CHECK (errorText ([&] { readMidiFile (path); }).find (path.string()) == 0);
}

TEST_CASE ("notes from an input keep their distances, a block later")
{
    StopCount stops;
    MidiQueue queue { stops };
    juce::MidiBuffer buffer;
    CHECK (queue.push (note (60), 1000));
    CHECK (queue.push (note (61), 1002));
    queue.pop (buffer, 1005, 48000, 480);
    std::vector<int> positions;

    for (const auto event : buffer)
        positions.push_back (event.samplePosition);

    CHECK (positions == std::vector<int> { 240, 336 });
    buffer.clear();
    queue.push (note (62), 500);  // long ago
    queue.push (note (63), 2000); // a clock that is ahead
    queue.pop (buffer, 1015, 48000, 480);
    positions.clear();

    for (const auto event : buffer)
        positions.push_back (event.samplePosition);

    CHECK (positions == std::vector<int> { 0, 479 });
}

TEST_CASE ("a queue that is full, and messages that are no notes, drop what comes")
{
    StopCount stops;
    MidiQueue queue { stops };
    const juce::uint8 longMessage[] { 0xf0, 1, 2, 3, 0xf7 };
    CHECK_FALSE (queue.push (juce::MidiMessage (longMessage, 5), 0));

    for (std::size_t i = 0; i < MidiQueue::capacity; ++i)
        CHECK (queue.push (note (60), 0));

    CHECK_FALSE (queue.push (note (60), 0));
}
