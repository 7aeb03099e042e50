#pragma once

#include "Bench.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_audio/PlayAndRecord.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_model/ModalModel.h>

#include <string>
#include <vector>

namespace antinode
{
/** The roles of the channels of an audio device, counted from 0. Ceramic k is output k. */
struct BenchChannels
{
    std::vector<int> sensors; ///< Inputs.
    int syncOutput = 0;
    int syncInput = -1; ///< -1: none.
};

/** The real bench: an audio device, its outputs on the amplifiers, its inputs on the sensors, one output looped back to
    one input. */
class AudioBench : public Bench
{
public:
    /** Opens the device.
        @param fullScale            The voltage of an output of 1, V
        @param fullScaleVelocity  The velocity of an input of 1, m/s
        @throws InputError  where it does not open as requested, or two roles have one channel [message thread] */
    AudioBench (AudioChoice, BenchChannels, Eigen::Index ceramics, double fullScale, double fullScaleVelocity);
    ~AudioBench() override;

    Eigen::Index sensors() const override;
    double fullScaleVelocity() const override { return velocity; }

    /** A run that lost samples is repeated, at most twice; an interrupted run ramps to 0 V and is incomplete. [message
        thread] */
    RunRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint, Eigen::Index points) override;

    /** The same of all ceramics at once. [message thread] */
    RunRecording playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                               Eigen::Index points) override;

private:
    RunRecording playRun (const Eigen::MatrixXd& run, Eigen::Index points);
    void waitFor (Take&);
    RunRecording toRecording (const Take&, Eigen::Index points) const;

    /** Before the device manager, which opens ALSA from JUCE 8 on. */
    struct QuietLibraries
    {
        QuietLibraries();
    };

    juce::ScopedJuceInitialiser_GUI juce;
    QuietLibraries quiet;
    juce::AudioDeviceManager manager;
    PlayAndRecord player;
    BenchChannels channels;
    std::vector<int> openOutputs, openInputs; ///< Ascending.
    double outputFullScale, velocity;
};

/** What to connect, to check with meter and scope, and to expect, before a device is measured: numbered steps with the
   numbers of this device, lines of text.
    @param points  N_p x 2, m; the first is where the sensor's signal is predicted
    @throws InputError  where the first point lies outside the surface, or as simulateBench
    [worker] Docs/Manual/measuring.md. */
std::string benchChecklist (const ModalModel&, const ExcitationSheet&, const Eigen::MatrixX2d& points,
                            const BenchChannels&, const SensorScale&);
} // namespace antinode
