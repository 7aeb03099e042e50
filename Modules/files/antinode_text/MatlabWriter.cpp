#include "MatlabWriter.h"

#include <antinode_base/InputError.h>

#include <array>
#include <bit>
#include <cstdint>

namespace antinode
{
namespace
{
static_assert (std::endian::native == std::endian::little, "numbers are written as they lie in memory");

// Types of data elements and the class of arrays of doubles, by the format's numbers.
constexpr std::uint32_t int8 = 1, int32 = 5, uint32 = 6, doubles = 9, matrix = 14;
constexpr std::uint32_t doubleClass = 6, complexFlag = 0x800;
constexpr std::size_t headerText = 124, alignment = 8, tagBytes = 8;

void append (std::string& bytes, const void* data, std::size_t size)
{
    bytes.append (static_cast<const char*> (data), size);
}

/** Type, length, content, and zeros up to eight bytes. */
void appendElement (std::string& bytes, std::uint32_t type, const void* data, std::size_t size)
{
    const std::array tag { type, static_cast<std::uint32_t> (size) };
    append (bytes, tag.data(), tagBytes);

    if (size > 0) // An empty matrix has no address.
        append (bytes, data, size);

    bytes.append ((alignment - size % alignment) % alignment, '\0');
}

void appendNumbers (std::string& bytes, const Eigen::MatrixXd& numbers)
{
    appendElement (bytes, doubles, numbers.data(), static_cast<std::size_t> (numbers.size()) * sizeof (double));
}

void require (const MatlabMatrix& written)
{
    constexpr Eigen::Index mostNumbers = (Eigen::Index (1) << 31) / Eigen::Index (2 * sizeof (double)) - 64;

    const auto isAllowed = [&] (const Eigen::MatrixXd& numbers)
    { return written.mayLack ? ! numbers.array().isInf().any() : numbers.allFinite(); };

    if (! isAllowed (written.real) || ! isAllowed (written.imaginary))
        throw InputError (written.name, "is not finite; nothing is written");

    if (written.real.size() > mostNumbers)
        throw InputError (written.name,
                          "has " + std::to_string (written.real.size())
                              + " numbers; allowed in a MATLAB file of version 5: " + std::to_string (mostNumbers));
}

std::string encodeMatrix (const MatlabMatrix& written)
{
    require (written);
    const auto isComplex = written.imaginary.size() > 0;
    const std::array<std::uint32_t, 2> flags { doubleClass | (isComplex ? complexFlag : 0), 0 };
    const std::array sizes { static_cast<std::int32_t> (written.real.rows()),
                             static_cast<std::int32_t> (written.real.cols()) };
    std::string content;
    appendElement (content, uint32, flags.data(), sizeof (flags));
    appendElement (content, int32, sizes.data(), sizeof (sizes));
    appendElement (content, int8, written.name.data(), written.name.size());
    appendNumbers (content, written.real);

    if (isComplex)
        appendNumbers (content, written.imaginary);

    return content;
}
} // namespace

std::string encodeMatlabFile (const std::vector<MatlabMatrix>& matrices)
{
    constexpr std::uint16_t version = 0x0100, order = 0x4d49; // "MI" as a number: readers see the order of bytes by it
    std::string bytes = "MATLAB 5.0 MAT-file, written by Antinode";
    bytes.resize (headerText - tagBytes, ' ');
    bytes.resize (headerText, '\0'); // no data of subsystems
    append (bytes, &version, sizeof (version));
    append (bytes, &order, sizeof (order));

    for (const auto& each : matrices)
    {
        const auto content = encodeMatrix (each);
        appendElement (bytes, matrix, content.data(), content.size());
    }

    return bytes;
}
} // namespace antinode
