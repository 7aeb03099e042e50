#pragma once

#include "MidiNotes.h"
#include "OutputRouter.h"
#include "StandaloneSettings.h"

#include <antinode_audio/PlayAndRecord.h>
#include <antinode_base/LockFreeExchange.h>
#include <juce_audio_devices/juce_audio_devices.h>
#include <juce_audio_processors/juce_audio_processors.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** The samples of an input on their way from the audio thread to the window, with peak and clipped samples. */
class InputTap
{
public:
    /** Samples from here on count as clipped, share of full scale. */
    static constexpr float clipping = 0.999F;

    /** Samples that the window does not take in time are left out; peak and clipped samples count all.
        @param samples  `count` of them; not a number counts as 0 [audio thread] */
    void write (const float* samples, int count);

    /** All samples since the last call, the oldest first, at most a third of a second at 192 kHz. One reader.
        [message thread] */
    std::vector<float> take();

    /** The largest magnitude since the last call, share of full scale. One reader. [any] */
    float takePeak() { return peak.exchange (0); }

    /** Samples at the end of the range so far. [any] */
    std::int64_t clippedSamples() const { return clipped; }

private:
    static constexpr std::size_t capacity = 1 << 16;

    RingQueue<float, capacity> waiting;
    std::atomic<float> peak { 0 };
    std::atomic<std::int64_t> clipped { 0 };
};

/** What the router must know of what plays. [audio thread] */
struct PlayedLevels
{
    std::function<double()> fullScaleVolts; ///< Of a sample of 1.0; 0: nothing plays yet.
    std::function<bool()> isArmed;
    std::function<void (float* to, int count, std::int64_t width)> writeMarker = {}; ///< As AudioEntry; none: never.
};

/** The callback of an audio device: the processor with all its buses, then the router, on the channels that are open.
    Blocks of any length: the processor never gets more samples than it was prepared for. */
class AudioCallback : public juce::AudioIODeviceCallback
{
public:
    /** All outlive this. @param processor  its outputs are the ceramics and, if it has one, the monitor; its inputs, if
        it has some, are those of fingers or of a sensor [message thread] */
    AudioCallback (juce::AudioProcessor& processor, OutputRouter&, MidiQueue&, PlayedLevels);

    /** The input of the device that each finger feels, or the sensor; those that are not open are silent. [any] */
    void setInputs (const FingerInputs&);

    /** Notes that begin with startSchedule(). [message thread] before a device calls */
    void setSchedule (EventSchedule wanted) { schedule = std::move (wanted); }

    /** Begins the schedule with the next block; a stop ends it. [any] */
    void startSchedule()
    {
        scheduleCommands = queue.stops().commands();
        scheduleWanted = true;
    }

    /** Samples since the schedule began; below 0 before. [any] */
    std::int64_t scheduleSamples() const { return schedulePosition; }

    /** Plays a take of a measurement in place of all else, as soon as the router is at it: its columns are the
       ceramics, then the sync channel on the output of the marker. A stop of any kind, a mute, disarming and another
       routing end it at 0 V.
        @param ceramics        how many
        @param stops           StopCount::commands() of when it was allowed: a stop since then voids it
        @param fullScaleVolts  of a sample of 1, whatever the loaded device has
        @param inputs          of the device, in the order of the recorded columns, counted from 0; below 0: none
        @throws InputError  as PlayAndRecord::begin [any] one thread */
    void playTake (std::shared_ptr<Take>, std::uint64_t stops, int ceramics, double fullScaleVolts,
                   const std::array<int, 2>& inputs);

    /** Ramps to 0 V and ends it. [any] */
    void stopTake() { recorder.stop(); }

    /** Blocks that the device's driver says that it has lost. [any] */
    int lostBlocks() const { return lost; }

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
    void noteInputs (const float* const* inputs, int inputCount);
    void fillInputs (int offset, int count);
    void playPart (int offset, int count);
    int playTakePart (int offset, int count);

    juce::AudioProcessor& processor;
    OutputRouter& router;
    MidiQueue& queue;
    PlayedLevels levels;
    EventSchedule schedule;
    InputTap inputTap;
    PlayAndRecord recorder;
    std::atomic<std::uint64_t> takeCommands { 0 }; ///< StopCount::commands() when it was allowed.
    std::atomic<int> takeCeramics { 0 };
    std::atomic<double> takeFullScale { 0 }; ///< V
    std::array<std::atomic<int>, 2> takeInputs {};
    std::atomic<int> lost { 0 };
    juce::AudioIODevice* device = nullptr; ///< While it calls.
    int takeStay = OutputRouter::noStay;   ///< Of the router, in which the take began. Of the audio thread.
    std::atomic<bool> scheduleWanted { false };
    std::atomic<std::uint64_t> scheduleCommands { 0 }; ///< StopCount::commands() when it was asked for.
    std::atomic<std::int64_t> schedulePosition { -1 }, played { 0 };
    std::atomic<double> rate { 0 };
    std::atomic<int> firstInput { -1 };
    std::array<std::atomic<int>, FingerInputs::fingers + 1> inputOfChannel; ///< Of fingers, then of their sensor.
    juce::CriticalSection errors;                                           ///< For the next line.
    juce::String lastError;

    juce::AudioBuffer<float>
        buffer; ///< Of the processor: ceramics, then monitor. Of the audio thread, as the next lines.
    juce::MidiBuffer notes, partNotes;
    std::vector<float> marker;
    std::array<int, OutputRouting::maximumOutputs> numbers {}; ///< Output of each channel that the device hands over.
    std::array<float*, OutputRouting::maximumOutputs> channels {}; ///< Of each output; null where it is not open.
    std::array<float*, OutputRouting::maximumOutputs> partChannels {};
    std::array<int, OutputRouting::maximumOutputs> inputNumbers {};   ///< As `numbers`.
    std::array<const float*, OutputRouting::maximumOutputs> heard {}; ///< Of each input; null where it is not open.
    int openChannels = 0, openInputChannels = 0;
    int longestPart = 1; ///< Samples that the processor was prepared for.
};
} // namespace antinode
