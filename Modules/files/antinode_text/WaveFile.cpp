#include "WaveFile.h"

#include "CsvText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_base/WholeFile.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
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

namespace
{
constexpr std::uint16_t integerCode = 1, floatCode = 3, extensibleCode = 0xfffe;

[[noreturn]] void fail (const std::string& source, const std::string& wrong)
{
    throw InputError (source, wrong);
}

std::uint64_t littleEndian (std::string_view bytes)
{
    std::uint64_t value = 0;

    for (std::size_t i = bytes.size(); i-- > 0;)
        value = value << 8 | static_cast<unsigned char> (bytes[i]);

    return value;
}

struct WaveFormat
{
    std::uint64_t code = 0, channels = 0, rate = 0, bits = 0;
    std::uint64_t bytes = 0; ///< Of a sample: by the block, which may leave more room than the bits need.

    bool isKnown() const
    {
        constexpr std::uint64_t mostBytes = 4;
        const auto needed = (bits + 7) / 8;
        return channels > 0 && rate > 0
               && ((code == integerCode && (bits == 16 || bits == 20 || bits == 24 || bits == 32) && bytes >= needed
                    && bytes <= mostBytes)
                   || (code == floatCode && (bits == 32 || bits == 64) && bytes == needed));
    }
};

/** What a heading says twice: the bytes of a block and of a second, by the format and as numbers of their own, which
   are 0 where they are not given. */
void requireAgreement (const WaveFormat& format, std::uint64_t block, std::uint64_t bytesASecond,
                       const std::string& source)
{
    if (block % std::max<std::uint64_t> (1, format.channels) != 0)
        fail (source, "contradicts itself: it has " + std::to_string (format.channels) + " channels in blocks of "
                          + std::to_string (block) + " bytes; record it again, or write it by another program");

    constexpr std::uint64_t field = 0xffffffff; // Of many channels only the lower bits are written.
    const auto ofBlock = format.rate * format.bytes * format.channels & field,
               ofBits = format.rate * ((format.bits + 7) / 8) * format.channels & field;

    if (bytesASecond != 0 && bytesASecond != ofBlock && bytesASecond != ofBits)
        fail (source, "contradicts itself: it has " + std::to_string (format.rate) + " blocks of "
                          + std::to_string (format.bytes * format.channels) + " bytes and "
                          + std::to_string (bytesASecond)
                          + " bytes per second; record it again, or write it by another program");
}

WaveFormat readFormat (std::string_view chunk, const std::string& source)
{
    constexpr std::size_t minimum = 16, validBits = 18, subFormat = 24;

    if (chunk.size() < minimum)
        fail (source, "is not a WAV file: its format chunk is truncated");

    const auto number = [&chunk] (std::size_t at, std::size_t bytes)
    { return littleEndian (chunk.substr (at, bytes)); };
    WaveFormat format { number (0, 2), number (2, 2), number (4, 4), number (14, 2), 0 };
    const auto block = number (12, 2);
    format.bytes = block == 0 ? (format.bits + 7) / 8 : block / std::max<std::uint64_t> (1, format.channels);

    if (format.code == extensibleCode && chunk.size() >= subFormat + 2)
    {
        format.code = number (subFormat, 2);
        const auto valid = number (validBits, 2);
        format.bits = format.code == integerCode && valid > 0 ? std::min (valid, format.bits) : format.bits;
    }

    requireAgreement (format, block, number (8, 4), source);

    if (! format.isKnown())
        fail (source, "has " + std::to_string (format.channels) + " channels of " + std::to_string (format.bits)
                          + " bits in " + std::to_string (format.bytes) + " bytes in format "
                          + std::to_string (format.code)
                          + "; allowed: integers of 16, 20, 24 or 32 bits, or floats of 32 or 64 bits");

    return format;
}

/** Whether 24 bits are the lower ones of four bytes, as ALSA records them: the lowest byte is in use, and the highest
   one only repeats the sign. */
bool areLower (const WaveFormat& format, std::string_view data)
{
    constexpr std::uint64_t threeBytes = 24;
    auto isLowUsed = false;

    if (format.code != integerCode || format.bits != threeBytes || format.bytes != 4)
        return false;

    for (std::size_t at = 0; at + 4 <= data.size(); at += 4)
    {
        const auto high = static_cast<unsigned char> (data[at + 3]);
        isLowUsed = isLowUsed || data[at] != 0;

        if (high != 0 && high != 0xff)
            return false;
    }

    return isLowUsed;
}

/** @param used  the bytes of a sample that hold it, the sign in the last one */
double decodeSample (const WaveFormat& format, const char* bytes, std::uint64_t used)
{
    if (format.code == integerCode)
    {
        // Into the upper bytes of 32 bits, so that the sign is in its place.
        std::int32_t value = 0;
        std::memcpy (reinterpret_cast<char*> (&value) + (sizeof (value) - used), bytes, used);
        return static_cast<double> (value) * 0x1p-31;
    }

    float single = 0;
    double whole = 0;
    std::memcpy (&single, bytes, sizeof (single));

    if (format.bytes == sizeof (whole))
        std::memcpy (&whole, bytes, sizeof (whole));

    return format.bytes == sizeof (whole) ? whole : static_cast<double> (single);
}

WaveSamples decodeSamples (const WaveFormat& format, std::string_view data, const std::string& source)
{
    const auto frames = data.size() / (format.bytes * format.channels);
    const auto used = areLower (format, data) ? format.bytes - 1 : format.bytes;

    if (frames == 0)
        fail (source, "has no samples");

    WaveSamples result { static_cast<double> (format.rate),
                         Eigen::MatrixXd (static_cast<Eigen::Index> (format.channels),
                                          static_cast<Eigen::Index> (frames)) };

    for (Eigen::Index i = 0; i < result.samples.size(); ++i)
        result.samples.data()[i] =
            decodeSample (format, data.data() + static_cast<std::size_t> (i) * format.bytes, used);

    if (! result.samples.allFinite())
        fail (source, "has a sample that is not finite");

    return result;
}

/** Sizes that recorders write first, and that stay where they are killed or write to a pipe. */
bool isPlaceholder (std::uint64_t size)
{
    return size == 0 || (size >= 0x7ffff000 && size <= 0x80000000) || (size >= 0xfffff000 && size <= 0xffffffff)
           || size > std::uint64_t { 1 } << 62;
}

/** The samples of a chunk of which a heading says the size: to the end of the file where that is a placeholder.
    @param fileSize  as the heading says, without its first eight bytes */
std::string_view sampleBytes (std::string_view rest, std::uint64_t size, std::uint64_t fileSize, std::size_t fileBytes,
                              const std::string& source)
{
    const auto isEmpty = size == 0 && fileSize + 8 == fileBytes;

    if (size > rest.size() && ! isPlaceholder (size))
        fail (source, "is cut off: its header gives " + std::to_string (size) + " bytes of samples, "
                          + std::to_string (rest.size()) + " are there; copy it again, or record it again");

    return rest.substr (0, isPlaceholder (size) && ! isEmpty && size != rest.size() ? rest.size() : size);
}

/** Refuses what is no WAV file; names other kinds of sound files. */
void requireWave (std::string_view bytes, const std::string& source)
{
    struct Kind
    {
        std::string_view mark, name;
    };

    constexpr std::size_t form = 8;
    constexpr std::array kinds { Kind { "riff", "a Wave64" }, Kind { "RIFX", "a RIFX" }, Kind { "FORM", "an AIFF" },
                                 Kind { "fLaC", "a FLAC" },   Kind { "OggS", "an Ogg" }, Kind { "caff", "a CAF" } };

    for (const auto& kind : kinds)
        if (bytes.starts_with (kind.mark))
            fail (source,
                  "is " + std::string (kind.name)
                      + " file; allowed: WAV, RF64 and BW64 files of integers of 16, 20, 24 or 32 bits or floats");

    const auto isWave = bytes.starts_with ("RIFF") || bytes.starts_with ("RF64") || bytes.starts_with ("BW64");

    if (! isWave || bytes.size() < form + 4 || bytes.substr (form, 4) != "WAVE")
        fail (source, "is not a WAV file");
}
} // namespace

WaveSamples decodeWave (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t riffHeader = 12, chunkHeader = 8, dataSizePlace = 8, sizesBytes = 16;
    requireWave (bytes, source);
    WaveFormat format;
    std::uint64_t fileSize = littleEndian (bytes.substr (4, 4)), longSize = 0; // The latter of ds64: of RF64 and BW64.

    for (auto rest = bytes.substr (riffHeader); rest.size() >= chunkHeader;)
    {
        const auto name = rest.substr (0, 4);
        const auto size = littleEndian (rest.substr (4, 4));
        const auto content = rest.substr (chunkHeader, size);

        if (name == "ds64" && content.size() >= sizesBytes)
        {
            fileSize = littleEndian (content.substr (0, 8));
            longSize = littleEndian (content.substr (dataSizePlace, 8));
        }

        if (name == "fmt ")
            format = readFormat (content, source);

        if (name == "data" && ! format.isKnown())
            fail (source, "is not a WAV file: its samples precede their format");

        if (name == "data")
            return decodeSamples (format,
                                  sampleBytes (rest.substr (chunkHeader),
                                               size == 0xffffffff && longSize > 0 ? longSize : size, fileSize,
                                               bytes.size(), source),
                                  source);

        // A byte fills up what is odd.
        rest.remove_prefix (std::min<std::uint64_t> (rest.size(), chunkHeader + size + size % 2));
    }

    fail (source, "is not a WAV file: it has no samples");
}

WaveSamples readWaveFile (const std::filesystem::path& path)
{
    return decodeWave (readWholeFile (path, { "a WAV file", std::uintmax_t { 4 } << 30 }),
                       printable (path.string(), 300));
}
} // namespace antinode
