#pragma once

#include "Field.h"
#include "RecordedSignals.h"

#include <antinode_bench/AudioBench.h>
#include <antinode_model/ModalModel.h>

#include <memory>
#include <vector>

namespace antinode
{
/** An audio device as a bench: which, and what its channels are wired to. */
struct BenchWiring
{
    AudioChoice audio;
    std::vector<int> sensorInputs; ///< Counted from 1; empty: input 1.
    int syncInput = 2;             ///< 0: none
    std::optional<int> syncOutput; ///< None: the one after the ceramics.
    SensorScale sensor;
};

/** Those of the command line only, but for the sensor's scale. [any] */
std::vector<Field> fields (BenchWiring&);

/** The channels for so many ceramics. [any] */
BenchChannels benchChannels (const BenchWiring&, Eigen::Index ceramics);

/** Opens the device.
    @throws InputError  without a sensitivity, and as AudioBench [message thread] */
std::unique_ptr<AudioBench> openAudioBench (const BenchWiring&, const ModalModel&, double sampleRate);
} // namespace antinode
