#pragma once

#include "Bench.h"

#include <antinode_audio/AudioChoice.h>
#include <antinode_audio/PlayAndRecord.h>

#include <vector>

namespace antinode
{
/** Which channels of an audio device serve what, counted from 0. Ceramic k is output k. */
struct BenchChannels
{
    std::vector<int> sensors; ///< Inputs.
    int syncOutput = 0;
    int syncInput = -1; ///< -1: none.
};

/** The real bench: an audio device, its outputs on the amplifiers, its inputs on the sensors, one output looped back to one input. */
class AudioBench : public Bench
{
public:
    /** Opens the device.
        @param fullScale            V that an output of 1 stands for
        @param velocityOfFullScale  m/s that an input of 1 stands for
        @throws InputError  where it does not open as it is asked for, or two roles have one channel [message thread] */
    AudioBench (AudioChoice, BenchChannels, Eigen::Index ceramics, double fullScale, double velocityOfFullScale);
    ~AudioBench() override;

    Eigen::Index sensors() const override;
    double velocityOfFullScale() const override { return velocity; }

    /** A turn that lost samples is played again, at most twice; one that is interrupted goes to 0 V and is not whole. [message thread] */
    TurnRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint, Eigen::Index points) override;

private:
    void waitFor (Take&);
    TurnRecording recordingOf (const Take&, Eigen::Index points) const;

    juce::ScopedJuceInitialiser_GUI juce;
    juce::AudioDeviceManager manager;
    PlayAndRecord player;
    BenchChannels channels;
    std::vector<int> openOutputs, openInputs; ///< Ascending.
    double outputFullScale, velocity;
};
} // namespace antinode
