#pragma once

#include "TakeBench.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** The roles of the channels of an audio device, counted from 0. */
struct BenchChannels
{
    std::vector<int> sensors; ///< Inputs.
    int syncOutput = 0;
    int syncInput = -1;       ///< -1: none.
    std::vector<int> outputs; ///< Of each ceramic, by the routing of the window that measures; empty: in their order.
};

/** The real bench: an audio device, its outputs on the amplifiers, its inputs on the sensors, one output looped back to
    one input. */
class AudioBench : public TakeBench
{
public:
    /** Opens the device.
        @param fullScale            The voltage of an output of 1, V
        @param fullScaleVelocity  The velocity of an input of 1, m/s
        @throws InputError  where it does not open as requested, or two roles have one channel [message thread] */
    AudioBench (AudioChoice, const BenchChannels&, Eigen::Index ceramics, double fullScale, double fullScaleVelocity);
    ~AudioBench() override;

private:
    double sampleRate() const override;
    std::int64_t calls() const override { return player.calls(); }
    int lostBlocks() const override { return manager.getXRunCount(); }
    void begin (std::shared_ptr<Take> take) override { player.begin (std::move (take)); }
    void stop() override { player.stop(); }
    void leave() override { manager.closeAudioDevice(); }
    std::string whyEnded() const override { return "was ended before its end"; }

    /** Before the device manager, which opens ALSA from JUCE 8 on. */
    struct QuietLibraries
    {
        QuietLibraries();
    };

    juce::ScopedJuceInitialiser_GUI juce;
    QuietLibraries quiet;
    juce::AudioDeviceManager manager;
    PlayAndRecord player;
};

/** What to connect, to check with meter and scope, and to expect, before a device is measured: numbered steps with the
   numbers of this device, lines of text.
    @param points  N_p x 2, m; the first is where the sensor's signal is predicted
    @throws InputError  where the first point lies outside the surface, or as simulateBench
    [worker] Docs/Manual/measuring.md. */
std::string benchChecklist (const ModalModel&, const ExcitationSheet&, const Eigen::MatrixX2d& points,
                            const BenchChannels&, const SensorScale&);
} // namespace antinode
