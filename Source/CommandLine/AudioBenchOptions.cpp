#include "AudioBenchOptions.h"

#include <antinode_audio/AudioTypes.h>
#include <antinode_base/InputError.h>

namespace antinode
{
void addAudioBenchOptions (CLI::App& command, AudioBenchOptions& options)
{
    constexpr int longestBlock = 1 << 16, maximumChannels = maximumDeviceOutputs;
    command.add_option ("--backend", options.audio.type, deviceTypeHelp());
    command.add_option ("--audio-device", options.audio.device,
                        "Audio device, a name from antinode-standalone --list-devices");
    command.add_option ("--block", options.audio.blockSize, "Block size, samples")
        ->check (CLI::Range (1, longestBlock));
    command
        .add_option ("--sensor-input", options.sensorInputs,
                     "Input of the sensor, counted from 1 (repeatable: several sensors at consecutive points)")
        ->allow_extra_args (false)
        ->check (CLI::Range (1, maximumChannels))
        ->default_str ("1");
    command.add_option ("--sync-input", options.syncInput, "Input wired to the sync output, counted from 1; 0: none")
        ->check (CLI::Range (0, maximumChannels))
        ->capture_default_str();
    command
        .add_option ("--sync-output", options.syncOutput,
                     "Sync output, counted from 1; default: the output after the ceramics")
        ->check (CLI::Range (1, maximumChannels));
}

BenchChannels benchChannels (const AudioBenchOptions& options, Eigen::Index ceramics)
{
    BenchChannels channels;
    channels.syncInput = options.syncInput - 1;
    channels.syncOutput = options.syncOutput > 0 ? options.syncOutput - 1 : static_cast<int> (ceramics);

    for (const auto input : options.sensorInputs)
        channels.sensors.push_back (input - 1);

    return channels;
}

std::unique_ptr<AudioBench> openAudioBench (const AudioBenchOptions& options, const ModalModel& model,
                                            double sampleRate)
{
    if (! (options.sensor.sensitivity > 0))
        throw InputError ("--sensitivity-mm-s-per-v", "is missing; give the sensitivity of the sensor in mm/s per V");

    auto choice = options.audio;
    choice.sampleRate = sampleRate;
    return std::make_unique<AudioBench> (choice, benchChannels (options, model.actuators()), model.actuators(),
                                         model.fullScaleVoltage, options.sensor.fullScaleVelocity());
}
} // namespace antinode
