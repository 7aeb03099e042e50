#pragma once

#include <Eigen/Core>

#include <string>

namespace antinode
{
/** One channel for a Tektronix AFG3000 generator (.tfw): the shape as 0..16382, and the settings to make by hand. */
struct TfwFile
{
    std::string bytes;
    double highVoltage = 0, lowVoltage = 0; ///< The voltages of 16382 and 0, V.
    double amplitudePeakToPeak = 0;         ///< V
    double offset = 0;                      ///< V
    double period = 0;                      ///< s
};

/** @param samples  N_s values, V, 2 to 65536
    @throws InputError  when there are too few or too many samples, or one is not finite
    [worker] Docs/FileFormats.md. */
TfwFile encodeTfw (const Eigen::VectorXd& samples, double sampleRate);
} // namespace antinode
