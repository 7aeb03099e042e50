#pragma once

#include "StandaloneSettings.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_session/AudioEntry.h>
#include <antinode_session/UserMessages.h>
#include <juce_audio_basics/juce_audio_basics.h>
#include <juce_audio_devices/juce_audio_devices.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
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

/** The MIDI inputs that are listened to; those that come and go are looked for every two seconds. */
class MidiInputs : private juce::MidiInputCallback, private juce::Timer
{
public:
    /** @param queueToFill  outlives this [message thread] */
    explicit MidiInputs (MidiQueue& queueToFill);
    ~MidiInputs() override;

    /** Opens the chosen ones, also those that appear later. [message thread] */
    void choose (const MidiChoice&);
    const MidiChoice& choice() const { return chosen; }

    /** Those that are plugged in. [message thread] */
    juce::Array<juce::MidiDeviceInfo> available() const { return juce::MidiInput::getAvailableDevices(); }

    /** Which of the chosen ones are missing or cannot be opened. [message thread] */
    std::vector<UserMessage> messages() const;

    /** How many are open. [message thread] */
    std::size_t opened() const { return inputs.size(); }

private:
    void handleIncomingMidiMessage (juce::MidiInput*, const juce::MidiMessage&) override;
    void timerCallback() override { update(); }
    void update();

    MidiQueue& queue;
    MidiChoice chosen;
    std::vector<std::unique_ptr<juce::MidiInput>> inputs;
    std::vector<std::string> refused; ///< Names of those that could not be opened.
    int missing = 0;                  ///< Chosen ones that are not plugged in.
};
} // namespace antinode
