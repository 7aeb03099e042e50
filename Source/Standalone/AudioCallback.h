#pragma once

#include "EventSchedule.h"
#include "InputTap.h"
#include "MidiQueue.h"
#include "OutputRouter.h"

#include <Processor/AntinodeProcessor.h>

#include <juce_audio_devices/juce_audio_devices.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace antinode
{
/** The callback of an audio device: the processor with all its buses, then the router, on the channels that are open.
    Blocks of any length. */
class AudioCallback : public juce::AudioIODeviceCallback
{
public:
    /** All outlive this. [message thread] */
    AudioCallback (AntinodeProcessor&, OutputRouter&, MidiQueue&);

    /** Notes that begin with startSchedule(). [message thread] before a device calls */
    void setSchedule (EventSchedule wanted) { schedule = std::move (wanted); }

    /** Begins the schedule with the next block. [any] */
    void startSchedule() { scheduleWanted = true; }

    /** Samples since the schedule began; below 0 before. [any] */
    std::int64_t scheduleSamples() const { return schedulePosition; }

    /** Samples since the program began: where it stands still, the device does. [any] */
    std::int64_t samplesPlayed() const { return played; }

    /** The samples of the first open input. [message thread] reads */
    InputTap& input() { return inputTap; }

    /** Its number, counted from 0; -1 where none is open. [any] */
    int inputNumber() const { return firstInput; }

    /** Hz; 0 while no device runs. [any] */
    double sampleRate() const { return rate; }

    /** Takes the error message of a failed device. [any but the audio thread] */
    juce::String takeError();

    void audioDeviceAboutToStart (juce::AudioIODevice*) override;
    void audioDeviceStopped() override;
    void audioDeviceError (const juce::String& message) override;
    void audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                           int outputCount, int count,
                                           const juce::AudioIODeviceCallbackContext&) override;

    /** For a device with these channels open, as audioDeviceAboutToStart. [message thread] nothing may be playing */
    void prepare (double sampleRate, int blockSize, const juce::BigInteger& openOutputs,
                  const juce::BigInteger& openInputs);

private:
    void gatherNotes (int count);
    void playPart (int offset, int count);

    AntinodeProcessor& processor;
    OutputRouter& router;
    MidiQueue& queue;
    EventSchedule schedule;
    InputTap inputTap;
    std::atomic<bool> scheduleWanted { false };
    std::atomic<std::int64_t> schedulePosition { -1 }, played { 0 };
    std::atomic<double> rate { 0 };
    std::atomic<int> firstInput { -1 };
    juce::CriticalSection errors; ///< For the next line.
    juce::String lastError;

    juce::AudioBuffer<float>
        buffer; ///< Of the processor: ceramics, then monitor. Of the audio thread, as the next lines.
    juce::MidiBuffer notes, partNotes;
    std::array<int, OutputRouting::maximumOutputs> numbers {}; ///< Output of each channel that the device hands over.
    std::array<float*, OutputRouting::maximumOutputs> channels {}; ///< Of each output; null where it is not open.
    std::array<float*, OutputRouting::maximumOutputs> partChannels {};
    int openChannels = 0;
};
} // namespace antinode
