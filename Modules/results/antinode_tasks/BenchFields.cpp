#include "BenchFields.h"

#include <antinode_audio/AudioTypes.h>

namespace antinode
{
std::vector<Field> fields (BenchWiring& wiring)
{
    constexpr int longestBlock = 1 << 16, maximumChannels = maximumDeviceOutputs;
    std::vector<Field> all {
        Field ("--backend", &wiring.audio.type, deviceTypeHelp()),
        Field ("--audio-device", &wiring.audio.device, "Audio device, a name from antinode-standalone --list-devices"),
        Field ("--block", &wiring.audio.blockSize, "Block size, samples").within (1, longestBlock).by ("the device's"),
        Field ("--sensor-input", &wiring.sensorInputs,
               "Input of the sensor, counted from 1 (repeatable: several sensors at consecutive points)")
            .within (1, maximumChannels)
            .by ("1"),
        Field ("--sync-input", &wiring.syncInput, "Input wired to the sync output, counted from 1; 0: none")
            .within (0, maximumChannels),
        Field ("--sync-output", &wiring.syncOutput, "Sync output, counted from 1")
            .within (1, maximumChannels)
            .by ("the output after the ceramics"),
    };

    for (auto& field : all)
        field.as ({});

    return all;
}

BenchChannels benchChannels (const BenchWiring& wiring, Eigen::Index ceramics)
{
    BenchChannels channels;
    channels.syncInput = wiring.syncInput - 1;
    channels.syncOutput = wiring.syncOutput.value_or (static_cast<int> (ceramics) + 1) - 1;

    for (const auto input : wiring.sensorInputs)
        channels.sensors.push_back (input - 1);

    if (channels.sensors.empty())
        channels.sensors = { 0 };

    return channels;
}

std::unique_ptr<AudioBench> openAudioBench (const BenchWiring& wiring, const ModalModel& model, double sampleRate)
{
    requireSensitivity (wiring.sensor);
    auto choice = wiring.audio;
    choice.sampleRate = sampleRate;
    return std::make_unique<AudioBench> (choice, benchChannels (wiring, model.actuators()), model.actuators(),
                                         model.fullScaleVoltage, wiring.sensor.fullScaleVelocity());
}
} // namespace antinode
