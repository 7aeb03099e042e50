#pragma once

#include "Field.h"

#include <antinode_measurement/RunAnalysis.h>

#include <vector>

namespace antinode
{
/** [any] */
std::vector<Field> fields (SensorScale&);

/** @throws InputError  where there is none [any] */
void requireSensitivity (const SensorScale&);

/** What was recorded while the voltages.wav of a folder was played: its recorded.csv, else its recorded.wav.
    @throws InputError  where there is neither [any] Docs/FileFormats.md. */
std::filesystem::path recordedFile (const std::filesystem::path& folder);

/** The velocities of a recorded.wav: channels x samples, m/s.
    @param sampleRate  that of voltages.wav, Hz
    @throws InputError  for another rate, a file that cannot be read, and without a sensitivity [worker] */
Eigen::MatrixXd recordedVelocities (const std::filesystem::path&, double sampleRate, const SensorScale&);
} // namespace antinode
