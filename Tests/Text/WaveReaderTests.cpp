#include "Support/ErrorText.h"

#include <antinode_text/WaveFile.h>
#include <antinode_text/WaveReader.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
std::string littleEndian (std::uint64_t value, int bytes)
{
    std::string text;

    for (int i = 0; i < bytes; ++i)
        text += static_cast<char> (value >> (8 * i) & 0xff);

    return text;
}

/** A plain file of integers or floats with a chunk of another kind before its samples. */
std::string plainWave (int code, int bits, int channels, const std::string& data)
{
    const auto format = littleEndian (static_cast<std::uint64_t> (code), 2)
                        + littleEndian (static_cast<std::uint64_t> (channels), 2) + littleEndian (48000, 4)
                        + littleEndian (0, 4) + littleEndian (0, 2)
                        + littleEndian (static_cast<std::uint64_t> (bits), 2);
    return "RIFF" + littleEndian (0, 4) + "WAVELIST" + littleEndian (3, 4) + std::string (4, 'x') + "fmt "
           + littleEndian (16, 4) + format + "data" + littleEndian (data.size(), 4) + data;
}
} // namespace

TEST_CASE ("What was written as WAV is read to the precision of a float, any channel count")
{
    const Eigen::MatrixXd samples = Eigen::MatrixXd::Random (33, 100) * 50;
    const auto read = decodeWave (encodeWave (samples, 50, 96000), "a.wav");
    CHECK (read.sampleRate == 96000);
    REQUIRE (read.samples.rows() == 33);
    CHECK ((read.samples * 50 - samples).cwiseAbs().maxCoeff() < 1e-5);
}

TEST_CASE ("Integers of 16, 24 and 32 bits and doubles are read with 1 as full scale")
{
    const auto expect = [] (const std::string& bytes)
    {
        const auto read = decodeWave (bytes, "a.wav").samples;
        REQUIRE (read.rows() == 2);
        CHECK (read (0, 0) == 0.5);
        CHECK (read (1, 0) == -1);
    };
    expect (plainWave (1, 16, 2, littleEndian (0x4000, 2) + littleEndian (0x8000, 2)));
    expect (plainWave (1, 24, 2, littleEndian (0x400000, 3) + littleEndian (0x800000, 3)));
    expect (plainWave (1, 32, 2, littleEndian (0x40000000, 4) + littleEndian (0x80000000, 4)));
    expect (plainWave (3, 64, 2, littleEndian (0x3fe0000000000000, 8) + littleEndian (0xbff0000000000000, 8)));
}

TEST_CASE ("Wrong or truncated WAV files are refused with a reason")
{
    const auto whole = encodeWave (Eigen::MatrixXd::Ones (2, 10), 1, 48000);
    const auto error = [] (const std::string& bytes) { return errorText ([&] { decodeWave (bytes, "a.wav"); }); };
    CHECK (error ("") == "a.wav: is not a WAV file");
    CHECK (error ("RIFF    WAVE") == "a.wav: is not a WAV file: it has no samples");
    CHECK (error (plainWave (1, 8, 1, "abc"))
           == "a.wav: has 1 channels of 8 bits in format 1; allowed: integers of 16, 24 or 32 bits, or floats of 32 "
              "or 64 bits");
    CHECK (error (plainWave (3, 32, 1, littleEndian (0x7fc00000, 4))) == "a.wav: has a sample that is not finite");
    CHECK (error (plainWave (1, 16, 1, "")) == "a.wav: has no samples");

    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK_NOTHROW (error (whole.substr (0, length)));

    CHECK (decodeWave (whole.substr (0, whole.size() - 5), "a.wav").samples.cols() == 9);
}
