#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <string_view>
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

/** The content of a WAV file. */
struct WaveSamples
{
    double sampleRate = 0;   ///< Hz
    Eigen::MatrixXd samples; ///< Channels x N_s; 1 is full scale.
};

/** Samples of a WAV, RF64 or BW64 file: integers of 16, 20, 24 or 32 bits, floats of 32 or 64, the plain or the
   extensible header, any channel count; chunks of other kinds are skipped. Samples with more bytes than they need are
   read by the block. Sizes that recorders leave when they are killed (0, 0x7fffffff, 0xffffffff) mean the end of the
   file; its last frame is left out where it is cut off.
    @param source  how errors name it
    @throws InputError  when it is no such file, contradicts itself, has fewer samples than it says or none, or one that
   is not finite [worker] Docs/FileFormats.md. */
WaveSamples decodeWave (std::string_view bytes, const std::string& source);

/** The same of a file of at most 4 GiB. @throws InputError  also when it cannot be read [worker] */
WaveSamples readWaveFile (const std::filesystem::path&);
} // namespace antinode
