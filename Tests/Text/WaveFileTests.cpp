#include "Support/ErrorText.h"

#include <antinode_text/WaveFile.h>

#include <catch2/catch.hpp>

#include <bit>
#include <cstdint>
#include <limits>

using namespace antinode;

namespace
{
std::uint32_t fieldOf (const std::string& bytes, std::size_t position, std::size_t count)
{
    std::uint32_t value = 0;

    for (std::size_t i = 0; i < count; ++i)
        value |= static_cast<std::uint32_t> (static_cast<unsigned char> (bytes.at (position + i))) << (8 * i);

    return value;
}

float sampleAt (const std::string& bytes, std::size_t index)
{
    return std::bit_cast<float> (fieldOf (bytes, 80 + 4 * index, 4));
}
} // namespace

// Layout: Microsoft, "Multiple Channel Audio Data and WAVE Files" (WAVE_FORMAT_EXTENSIBLE,
// KSDATAFORMAT_SUBTYPE_IEEE_FLOAT).
TEST_CASE ("A WAV file has the extensible float format, discrete channels and interleaved samples", "[files]")
{
    Eigen::MatrixXd volts (3, 2);
    volts << 150, -75, 0, 15, 300, 1e-3;
    const auto bytes = encodeWave (volts, 150, 192000);
    REQUIRE (bytes.size() == 80 + 24);
    CHECK (bytes.substr (0, 4) == "RIFF");
    CHECK (fieldOf (bytes, 4, 4) == bytes.size() - 8);
    CHECK (bytes.substr (8, 8) == "WAVEfmt ");
    CHECK (fieldOf (bytes, 16, 4) == 40);
    CHECK (fieldOf (bytes, 20, 2) == 0xfffe);
    CHECK (fieldOf (bytes, 22, 2) == 3);
    CHECK (fieldOf (bytes, 24, 4) == 192000);
    CHECK (fieldOf (bytes, 28, 4) == 192000 * 12);
    CHECK (fieldOf (bytes, 32, 2) == 12);
    CHECK (fieldOf (bytes, 34, 2) == 32);
    CHECK (fieldOf (bytes, 36, 2) == 22);
    CHECK (fieldOf (bytes, 38, 2) == 32);
    CHECK (fieldOf (bytes, 40, 4) == 0);
    CHECK (bytes.substr (44, 16) == std::string ("\x03\0\0\0\0\0\x10\0\x80\0\0\xaa\0\x38\x9b\x71", 16));
    CHECK (bytes.substr (60, 4) == "fact");
    CHECK (fieldOf (bytes, 64, 4) == 4);
    CHECK (fieldOf (bytes, 68, 4) == 2);
    CHECK (bytes.substr (72, 4) == "data");
    CHECK (fieldOf (bytes, 76, 4) == 24);
    CHECK (sampleAt (bytes, 0) == 1.0f);
    CHECK (sampleAt (bytes, 1) == 0.0f);
    CHECK (sampleAt (bytes, 2) == 2.0f);
    CHECK (sampleAt (bytes, 3) == -0.5f);
    CHECK (sampleAt (bytes, 4) == 0.1f);
    CHECK (sampleAt (bytes, 5) == static_cast<float> (1e-3 / 150));
}

TEST_CASE ("A WAV file takes any rate and many channels", "[files]")
{
    const auto fast = encodeWave (Eigen::MatrixXd::Zero (65, 10), 1, 4294967295.0);
    CHECK (fieldOf (fast, 22, 2) == 65);
    CHECK (fieldOf (fast, 24, 4) == 4294967295u);
    CHECK (fieldOf (fast, 28, 4) == 4294967295u);
    CHECK (fieldOf (fast, 76, 4) == 65 * 10 * 4);
    CHECK (encodeWave (Eigen::MatrixXd (16383, 0), 1, 48000).size() == 80);
}

TEST_CASE ("WAV files that cannot be are refused", "[files]")
{
    const Eigen::MatrixXd one = Eigen::MatrixXd::Zero (1, 1);
    const auto infinity = std::numeric_limits<double>::infinity();
    CHECK (errorText ([&] { encodeWave (Eigen::MatrixXd (0, 1), 1, 48000); })
           == "WAV: has 0 channels; allowed: 1 to 16383");
    CHECK (errorText ([&] { encodeWave (Eigen::MatrixXd (16384, 0), 1, 48000); })
           == "WAV: has 16384 channels; allowed: 1 to 16383");
    CHECK (errorText ([&] { encodeWave (one, 1, 44100.5); })
           == "WAV: has a sample rate of 44100.5 Hz; allowed: whole numbers from 1 to 4294967295 Hz");

    for (const auto rate : { 0.0, -1.0, 4294967296.0, infinity, std::nan ("") })
        CHECK_FALSE (errorText ([&] { encodeWave (one, 1, rate); }).empty());

    for (const auto wrong : { infinity, std::nan (""), 1e300 })
        CHECK (errorText ([&] { encodeWave (Eigen::MatrixXd::Constant (1, 1, wrong), 1, 48000); })
               == "WAV: has a value that is not finite in channel 1");

    CHECK_FALSE (errorText ([&] { encodeWave (one, 0, 48000); }).empty());
}

TEST_CASE ("CSV has a column of time and one a channel, 9 significant digits", "[files]")
{
    Eigen::MatrixXd velocities (2, 3);
    velocities << 0, 1.0 / 3, -12345.678912, 1e-12, 40, -0.5;
    CHECK (encodeCsv (velocities, { "velocity_mm_s_1", "at \"24\", top" }, 48000, 0.025)
           == "time_s,velocity_mm_s_1,\"at \"\"24\"\", top\"\n"
              "0.025,0,1e-12\n"
              "0.0250208333,0.333333333,40\n"
              "0.0250416667,-12345.6789,-0.5\n");
    CHECK (encodeCsv (Eigen::MatrixXd (0, 2), {}, 10, 0) == "time_s\n0\n0.1\n");
    CHECK (errorText ([&] { encodeCsv (velocities, { "one" }, 48000, 0); }) == "CSV: has 1 names for 2 columns");
    velocities (0, 0) = std::nan ("");
    CHECK (errorText (
               [&] {
                   encodeCsv (velocities, { "a", "b" }, 48000, 0);
               })
           == "CSV: has a value that is not finite");
}
