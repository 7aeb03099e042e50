#pragma once

#include "SensorOptions.h"

#include <antinode_bench/AudioBench.h>
#include <antinode_model/ModalModel.h>

#include <memory>
#include <vector>

namespace antinode
{
/** An audio device as a bench: which, and what its channels are wired to. */
struct AudioBenchOptions
{
    AudioChoice audio;
    std::vector<int> sensorInputs { 1 }; // counted from 1
    int syncInput = 2;                   // 0: none
    int syncOutput = 0;                  // 0: the one after the ceramics
    SensorOptions sensor;
};

/** Adds them to a sub-command, but those of the sensor (addSensorOptions). The struct must live as long as the app. */
void addAudioBenchOptions (CLI::App&, AudioBenchOptions&);

/** The channels for so many ceramics. [any] */
BenchChannels benchChannels (const AudioBenchOptions&, Eigen::Index ceramics);

/** Opens the device.
    @throws InputError  without a sensitivity, and as AudioBench [message thread] */
std::unique_ptr<AudioBench> openAudioBench (const AudioBenchOptions&, const ModalModel&, double sampleRate);
} // namespace antinode
