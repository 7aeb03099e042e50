#include "Support/ErrorText.h"

#include <antinode_text/WaveFile.h>

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
           == "a.wav: has 1 channels of 8 bits in 1 bytes in format 1; allowed: integers of 16, 20, 24 or 32 bits, or "
              "floats of 32 or 64 bits");
    CHECK (error (plainWave (3, 32, 1, littleEndian (0x7fc00000, 4))) == "a.wav: has a sample that is not finite");
    CHECK (error (plainWave (1, 16, 1, "")) == "a.wav: has no samples");

    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK_NOTHROW (error (whole.substr (0, length)));

    CHECK (
        error (whole.substr (0, whole.size() - 5))
        == "a.wav: is cut off: its header gives 80 bytes of samples, 75 are there; copy it again, or record it again");
    CHECK (error ("riff" + std::string (60, 'x')).starts_with ("a.wav: is a Wave64 file; allowed: WAV, RF64 and BW64"));
}

TEST_CASE ("Sizes that a killed recorder leaves are read to the end of the file")
{
    const auto whole = plainWave (1, 16, 2, littleEndian (0x4000, 2) + littleEndian (0x8000, 2) + "x");
    const auto place = whole.find ("data") + 4;

    for (const auto size : { 0U, 0x7fffffffU, 0x7ffff000U, 0x80000000U, 0xffffffffU })
    {
        auto killed = whole;
        killed.replace (place, 4, littleEndian (size, 4));
        const auto read = decodeWave (killed, "a.wav").samples;
        REQUIRE (read.cols() == 1); // The last frame is cut off.
        CHECK (read (0, 0) == 0.5);
    }

    // A recording of no length, which says so twice, has none, whatever follows it.
    auto empty = plainWave (1, 16, 2, "");
    empty += "LIST" + littleEndian (4, 4) + "abcd";
    empty.replace (4, 4, littleEndian (empty.size() - 8, 4));
    CHECK (errorText ([&] { decodeWave (empty, "a.wav"); }) == "a.wav: has no samples");
}

TEST_CASE (
    "Samples in more bytes than they need are read by the block, and headings that contradict themselves refused")
{
    const auto withBlock = [] (int bits, int channels, int block, int bytesASecond, const std::string& data)
    {
        auto bytes = plainWave (1, bits, channels, data);
        const auto format = bytes.find ("fmt ") + 8;
        bytes.replace (format + 8, 4, littleEndian (static_cast<std::uint64_t> (bytesASecond), 4));
        return bytes.replace (format + 12, 2, littleEndian (static_cast<std::uint64_t> (block), 2));
    };
    const auto read = [] (const std::string& bytes) { return decodeWave (bytes, "a.wav").samples; };
    const auto error = [&] (const std::string& bytes) { return errorText ([&] { read (bytes); }); };

    // ALSA's S24_LE has its bits below, with or without the sign above; others have them above.
    const auto lower =
        read (withBlock (24, 1, 4, 4 * 48000, littleEndian (0xffc00001, 4) + littleEndian (0x00c00001, 4)));
    REQUIRE (lower.cols() == 2);
    CHECK (lower (0, 0) == -0.5 + 0x1p-23);
    CHECK (lower (0, 1) == lower (0, 0));
    CHECK (read (withBlock (24, 1, 4, 4 * 48000, littleEndian (0xc0000000, 4))) (0, 0) == -0.5);
    CHECK (read (withBlock (20, 1, 3, 0, littleEndian (0xc00000, 3))) (0, 0) == -0.5);
    CHECK (error (withBlock (24, 2, 7, 0, std::string (14, 'x')))
               .find ("contradicts itself: it has 2 channels in blocks of 7")
           != std::string::npos);
    CHECK (error (withBlock (24, 1, 2, 0, std::string (4, 'x'))).find ("24 bits in 2 bytes") != std::string::npos);
    CHECK (error (withBlock (16, 1, 2, 88200, std::string (4, 'x'))).find ("contradicts itself: it has 48000 blocks")
           != std::string::npos);
}

TEST_CASE ("RF64 and BW64 files have their sizes in a chunk of their own")
{
    const auto plain = plainWave (1, 16, 1, littleEndian (0x4000, 2) + littleEndian (0xc000, 2) + "LIST");

    for (const auto* const mark : { "RF64", "BW64" })
        for (const std::uint64_t size : { std::uint64_t { 4 }, std::uint64_t { 0 }, ~std::uint64_t { 0 } })
        {
            auto bytes = plain;
            bytes.replace (bytes.find ("data") + 4, 4, littleEndian (0xffffffff, 4));
            bytes.insert (12, "ds64" + littleEndian (28, 4) + littleEndian (0, 8) + littleEndian (size, 8)
                                  + littleEndian (0, 8) + littleEndian (0, 4));
            bytes.replace (0, 4, mark);
            const auto read = decodeWave (bytes, "a.wav").samples;
            CHECK (read.cols() == (size == 4 ? 2 : 4));
            CHECK (read (0, 1) == -0.5);
        }
}
