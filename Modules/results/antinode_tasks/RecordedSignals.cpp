#include "RecordedSignals.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/WaveFile.h>

namespace antinode
{
std::vector<Field> fields (SensorScale& scale)
{
    constexpr double least = 1e-9, most = 1e9;
    return { Field ("--sensitivity-mm-s-per-v", &scale.sensitivity, "Sensitivity of the sensor, mm/s per V")
                 .as ("sensitivity_mm_s_per_V")
                 .within (least, most)
                 .by ("none"),
             Field ("--input-full-scale-v", &scale.inputFullScale, "Input voltage of a recorded sample of 1, V")
                 .as ("input_full_scale_V")
                 .within (least, most) };
}

void requireSensitivity (const SensorScale& scale)
{
    if (! (scale.sensitivity > 0))
        throw InputError ("--sensitivity-mm-s-per-v", "is missing; give the sensitivity of the sensor in mm/s per V");
}

std::filesystem::path recordedFile (const std::filesystem::path& folder)
{
    for (const auto* const name : { "recorded.csv", "recorded.wav" })
        if (std::filesystem::exists (folder / name))
            return folder / name;

    throw InputError (folder.string(), "has neither recorded.csv nor recorded.wav, the recording of its voltages.wav");
}

Eigen::MatrixXd recordedVelocities (const std::filesystem::path& path, double sampleRate, const SensorScale& sensor)
{
    requireSensitivity (sensor);
    const auto wave = readWaveFile (path);

    if (wave.sampleRate != sampleRate)
        throw InputError (path.string(), "has " + inWords (wave.sampleRate) + " Hz; allowed: the rate of voltages.wav, "
                                             + inWords (sampleRate) + " Hz");

    return sensor.fullScaleVelocity() * wave.samples;
}
} // namespace antinode
