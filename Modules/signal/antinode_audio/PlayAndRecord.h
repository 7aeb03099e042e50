#pragma once

#include <antinode_engine/VoltageLimiter.h>

#include <Eigen/Core>
#include <juce_audio_devices/juce_audio_devices.h>

#include <atomic>
#include <memory>

namespace antinode
{
/** A signal to play once and the recording made meanwhile: planar channels, one per column. */
struct Take
{
    Eigen::MatrixXf played;                ///< Samples x open outputs, of full scale.
    Eigen::MatrixXf recorded;              ///< Samples x open inputs: filled in.
    std::atomic<Eigen::Index> samples = 0; ///< Number of samples played: fewer than all, where it was ended before.
    std::atomic<bool> isDone = false;      ///< Once true, the audio thread no longer accesses the take.
};

/** Plays takes, one after the other: as the callback of an audio device, with silence between them, or within another
   callback. A take that is stopped goes to 0 V on a ramp. */
class PlayAndRecord : public juce::AudioIODeviceCallback
{
public:
    /** Starts a take with the next block.
        @throws InputError  where the previous one is not done: its device has stopped [any] one thread */
    void begin (std::shared_ptr<Take>);

    /** Ramps to 0 V and ends the take. [any] */
    void stop() { stops = true; }

    /** The number of callbacks from the device. [any] */
    std::int64_t calls() const { return called; }

    /** Before anything plays. @param sampleRate  Hz [any] */
    void prepare (double sampleRate);

    /** The next samples of a take, where there is one: it overwrites the outputs. Inputs that are null record nothing.
        [audio thread] */
    void process (const float* const* inputs, int inputCount, float* const* outputs, int outputCount, int count);

    /** Whether a take plays. [audio thread] */
    bool hasBegun() const
    {
        const auto* const take = current.load();
        return take != nullptr && take->samples > 0;
    }

    /** Ends a take that has begun, and one that has not where it may not begin. What it played is ramped elsewhere.
        [audio thread] */
    void cut (bool mayBegin);

    void audioDeviceAboutToStart (juce::AudioIODevice*) override;
    void audioDeviceStopped() override {}
    void audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                           int outputCount, int count,
                                           const juce::AudioIODeviceCallbackContext&) override;

private:
    void end (Take&);
    void run (Take&, const float* const* inputs, int inputCount, float* const* outputs, int outputCount, int count);

    std::shared_ptr<Take> kept,
        before; ///< Of who begins takes: the audio thread may have it as long as its device is silent.
    std::atomic<Take*> current { nullptr };
    std::atomic<bool> stops { false };
    std::atomic<std::int64_t> called { 0 };
    SafetyRamp ramp { 1 };
    std::int64_t rampSamples = 0;
    bool isStopping = false; ///< On the audio thread.
};
} // namespace antinode
