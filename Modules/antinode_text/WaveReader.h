#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** The content of a WAV file. */
struct WaveSamples
{
    double sampleRate = 0;   ///< Hz
    Eigen::MatrixXd samples; ///< Channels x N_s; 1 is full scale.
};

/** Samples of a WAV file: integers of 16, 24 or 32 bits, floats of 32 or 64, the plain or the extensible header, any
   channel count; chunks of other kinds are skipped. A last frame that is cut off, as by a recorder that was switched
   off, is left out.
    @param source  how errors name it
    @throws InputError  when it is no such file, has no samples, or one that is not finite
    [worker] Docs/FileFormats.md. */
WaveSamples decodeWave (std::string_view bytes, const std::string& source);

/** The same of a file of at most 4 GiB. @throws InputError  also when it cannot be read [worker] */
WaveSamples readWaveFile (const std::filesystem::path&);
} // namespace antinode
