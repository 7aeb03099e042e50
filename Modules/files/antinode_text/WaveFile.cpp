#include "WaveFile.h"

#include "CsvText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace antinode
{
namespace
{
constexpr std::uint64_t largestNumber32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t bytesPerSample = 4;
constexpr std::uint64_t bytesBeforeData = 80; ///< RIFF and WAVE 12, fmt 8 + 40, fact 8 + 4, data's header 8.

template <typename Integer>
void appendLittleEndian (std::string& bytes, Integer value)
{
    for (std::size_t i = 0; i < sizeof (Integer); ++i)
        bytes += static_cast<char> (value >> (8 * i) & 0xff);
}

struct WaveShape
{
    std::uint64_t channels = 0, frames = 0, rate = 0;

    std::uint64_t dataBytes() const { return channels * frames * bytesPerSample; }
};

void validate (const WaveShape& shape, double sampleRate)
{
    constexpr std::uint64_t maximumChannels = 16383;

    if (shape.channels < 1 || shape.channels > maximumChannels)
        throw InputError ("WAV", "has " + std::to_string (shape.channels) + " channels; allowed: 1 to "
                                     + std::to_string (maximumChannels));

    if (! (sampleRate >= 1 && sampleRate <= static_cast<double> (largestNumber32)
           && sampleRate == std::floor (sampleRate)))
        throw InputError ("WAV", "has a sample rate of " + numberText (sampleRate)
                                     + " Hz; allowed: whole numbers from 1 to " + std::to_string (largestNumber32)
                                     + " Hz");

    if (shape.frames > largestNumber32 / (bytesPerSample * shape.channels)
        || shape.dataBytes() > largestNumber32 - (bytesBeforeData - 8))
        throw InputError ("WAV", "has " + std::to_string (shape.frames)
                                     + " samples per channel; allowed: up to 4 GiB in total");
}

void appendHeader (std::string& bytes, const WaveShape& shape)
{
    constexpr std::uint16_t extensible = 0xfffe, extensionBytes = 22;
    constexpr std::uint32_t formatBytes = 40, factBytes = 4, noSpeakers = 0;
    // KSDATAFORMAT_SUBTYPE_IEEE_FLOAT, 00000003-0000-0010-8000-00aa00389b71
    constexpr std::string_view floatFormat ("\x03\0\0\0\0\0\x10\0\x80\0\0\xaa\0\x38\x9b\x71", 16);
    const auto frameBytes = bytesPerSample * shape.channels;

    bytes += "RIFF";
    appendLittleEndian (bytes, static_cast<std::uint32_t> (bytesBeforeData - 8 + shape.dataBytes()));
    bytes += "WAVEfmt ";
    appendLittleEndian (bytes, formatBytes);
    appendLittleEndian (bytes, extensible);
    appendLittleEndian (bytes, static_cast<std::uint16_t> (shape.channels));
    appendLittleEndian (bytes, static_cast<std::uint32_t> (shape.rate));
    // Bytes a second, which readers use for display only, do not fit at the highest rates.
    appendLittleEndian (bytes, static_cast<std::uint32_t> (std::min (shape.rate * frameBytes, largestNumber32)));
    appendLittleEndian (bytes, static_cast<std::uint16_t> (frameBytes));
    appendLittleEndian (bytes, static_cast<std::uint16_t> (8 * bytesPerSample));
    appendLittleEndian (bytes, extensionBytes);
    appendLittleEndian (bytes, static_cast<std::uint16_t> (8 * bytesPerSample));
    appendLittleEndian (bytes, noSpeakers);
    bytes += floatFormat;
    bytes += "fact";
    appendLittleEndian (bytes, factBytes);
    appendLittleEndian (bytes, static_cast<std::uint32_t> (shape.frames));
    bytes += "data";
    appendLittleEndian (bytes, static_cast<std::uint32_t> (shape.dataBytes()));
}
} // namespace

std::string encodeWave (const Eigen::MatrixXd& samples, double fullScale, double sampleRate)
{
    WaveShape shape { static_cast<std::uint64_t> (samples.rows()), static_cast<std::uint64_t> (samples.cols()), 0 };
    validate (shape, sampleRate);
    shape.rate = static_cast<std::uint64_t> (sampleRate);

    std::string bytes;
    bytes.reserve (bytesBeforeData + shape.dataBytes());
    appendHeader (bytes, shape);

    for (Eigen::Index n = 0; n < samples.cols(); ++n)
    {
        checkWatch();

        for (Eigen::Index i = 0; i < samples.rows(); ++i)
        {
            const auto value = static_cast<float> (samples (i, n) / fullScale);

            if (! std::isfinite (value))
                throw InputError ("WAV", "has a value that is not finite in channel " + std::to_string (i + 1));

            appendLittleEndian (bytes, std::bit_cast<std::uint32_t> (value));
        }
    }

    return bytes;
}

std::string encodeCsv (const Eigen::MatrixXd& samples, const std::vector<std::string>& columns, double sampleRate,
                       double firstTime)
{
    if (static_cast<Eigen::Index> (columns.size()) != samples.rows())
        throw InputError ("CSV", "has " + std::to_string (columns.size()) + " names for "
                                     + std::to_string (samples.rows()) + " columns");

    constexpr int significantDigits = 9;
    std::string text = "time_s";

    for (const auto& column : columns)
        text += ',' + csvField (column);

    for (Eigen::Index n = 0; n < samples.cols(); ++n)
    {
        checkWatch();
        text += '\n';
        appendCsvNumber (text, firstTime + static_cast<double> (n) / sampleRate, significantDigits);

        for (Eigen::Index i = 0; i < samples.rows(); ++i)
        {
            text += ',';
            appendCsvNumber (text, samples (i, n), significantDigits);
        }
    }

    return text + '\n';
}
} // namespace antinode
