#pragma once

#include <antinode_engine/VoltageLimiter.h>

#include <Eigen/Core>
#include <juce_audio_devices/juce_audio_devices.h>

#include <atomic>

namespace antinode
{
/** A signal to play once and the recording made meanwhile: planar channels, one per column. */
struct Take
{
    Eigen::MatrixXf played;                ///< Samples x open outputs, of full scale.
    Eigen::MatrixXf recorded;              ///< Samples x open inputs: filled in.
    std::atomic<Eigen::Index> samples = 0; ///< Number of samples played.
    std::atomic<bool> isDone = false;      ///< Once true, the audio thread no longer accesses the take.
};

/** Plays takes on an audio device, one after the other, and silence between them. A take that is stopped goes to 0 V on
    a ramp. */
class PlayAndRecord : public juce::AudioIODeviceCallback
{
public:
    /** Starts a take with the next block; the previous one must be done. The take outlives isDone. [any] one thread */
    void begin (Take&);

    /** Ramps to 0 V and ends the take. [any] */
    void stop() { stops = true; }

    /** The number of callbacks from the device. [any] */
    std::int64_t calls() const { return called; }

    void audioDeviceAboutToStart (juce::AudioIODevice*) override;
    void audioDeviceStopped() override {}
    void audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                           int outputCount, int count,
                                           const juce::AudioIODeviceCallbackContext&) override;

private:
    void run (Take&, const float* const* inputs, int inputCount, float* const* outputs, int outputCount, int count);

    std::atomic<Take*> current { nullptr };
    std::atomic<bool> stops { false };
    std::atomic<std::int64_t> called { 0 };
    SafetyRamp ramp { 1 };
    std::int64_t rampSamples = 0;
    bool isStopping = false; ///< On the audio thread.
};
} // namespace antinode
