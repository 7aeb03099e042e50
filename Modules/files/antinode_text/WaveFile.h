#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
/** Samples as a float32 WAV (WAVE_FORMAT_EXTENSIBLE, discrete channels), any channel count, any integral rate to 2^32 -
   1 Hz.
    @param samples    channels x N_s, any unit
    @param fullScale  the value of 1.0, same unit
    @return           the file's bytes
    @throws InputError  when there are more than 4 GiB or 16383 channels (the format's block size has 16 bits), the rate
   does not fit, or a sample is not finite [worker] */
std::string encodeWave (const Eigen::MatrixXd& samples, double fullScale, double sampleRate);

/** Samples as CSV: time_s and one column per channel, 9 significant digits.
    @param columns  the channels' names with their unit, for example "velocity_mm_s_1"
    @param firstTime  s, of the first sample
    @throws InputError  when a sample is not finite
    [worker] */
std::string encodeCsv (const Eigen::MatrixXd& samples, const std::vector<std::string>& columns, double sampleRate,
                       double firstTime);
} // namespace antinode
