#include "WaveReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/WholeFile.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace antinode
{
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

    bool isKnown() const
    {
        return channels > 0 && rate > 0
               && ((code == integerCode && (bits == 16 || bits == 24 || bits == 32))
                   || (code == floatCode && (bits == 32 || bits == 64)));
    }
};

WaveFormat readFormat (std::string_view chunk, const std::string& source)
{
    constexpr std::size_t minimum = 16, subFormat = 24;

    if (chunk.size() < minimum)
        fail (source, "is not a WAV file: its format chunk is truncated");

    WaveFormat format { littleEndian (chunk.substr (0, 2)), littleEndian (chunk.substr (2, 2)),
                        littleEndian (chunk.substr (4, 4)), littleEndian (chunk.substr (14, 2)) };

    if (format.code == extensibleCode && chunk.size() >= subFormat + 2)
        format.code = littleEndian (chunk.substr (subFormat, 2));

    if (! format.isKnown())
        fail (source, "has " + std::to_string (format.channels) + " channels of " + std::to_string (format.bits)
                          + " bits in format " + std::to_string (format.code)
                          + "; allowed: integers of 16, 24 or 32 bits, or floats of 32 or 64 bits");

    return format;
}

double decodeSample (const WaveFormat& format, const char* bytes)
{
    const auto size = format.bits / 8;

    if (format.code == integerCode)
    {
        // Into the upper bytes of 32 bits, so that the sign is in its place.
        std::int32_t value = 0;
        std::memcpy (reinterpret_cast<char*> (&value) + (sizeof (value) - size), bytes, size);
        return static_cast<double> (value) * 0x1p-31;
    }

    float single = 0;
    double whole = 0;
    std::memcpy (&single, bytes, sizeof (single));

    if (size == sizeof (whole))
        std::memcpy (&whole, bytes, sizeof (whole));

    return size == sizeof (whole) ? whole : static_cast<double> (single);
}

WaveSamples decodeSamples (const WaveFormat& format, std::string_view data, const std::string& source)
{
    const auto size = format.bits / 8, frame = size * format.channels;
    const auto frames = data.size() / frame;

    if (frames == 0)
        fail (source, "has no samples");

    WaveSamples result { static_cast<double> (format.rate),
                         Eigen::MatrixXd (static_cast<Eigen::Index> (format.channels),
                                          static_cast<Eigen::Index> (frames)) };

    for (Eigen::Index i = 0; i < result.samples.size(); ++i)
        result.samples.data()[i] = decodeSample (format, data.data() + static_cast<std::size_t> (i) * size);

    if (! result.samples.allFinite())
        fail (source, "has a sample that is not finite");

    return result;
}
} // namespace

WaveSamples decodeWave (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t riffHeader = 12, chunkHeader = 8;

    if (bytes.size() < riffHeader || bytes.substr (0, 4) != "RIFF" || bytes.substr (8, 4) != "WAVE")
        fail (source, "is not a WAV file");

    WaveFormat format;

    for (auto rest = bytes.substr (riffHeader); rest.size() >= chunkHeader;)
    {
        const auto size = littleEndian (rest.substr (4, 4));
        const auto content = rest.substr (chunkHeader, size);

        if (rest.substr (0, 4) == "fmt ")
            format = readFormat (content, source);

        if (rest.substr (0, 4) == "data" && ! format.isKnown())
            fail (source, "is not a WAV file: its samples precede their format");

        if (rest.substr (0, 4) == "data")
            return decodeSamples (format, content, source);

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
