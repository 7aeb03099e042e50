#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** The properties of all bytes of a MATLAB file of level 5. */
struct MatlabForm
{
    std::string source; ///< How errors name the file.
    bool isBigEndian = false;

    /** @throws InputError  the file is damaged, and how */
    [[noreturn]] void failDamaged (const std::string& how) const;
};

/** Types of data elements, by the format's numbers. */
enum class MatlabType : std::uint32_t
{
    int8 = 1,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    single,
    doublePrecision = 9,
    int64 = 12,
    uint64,
    matrix,
    compressed,
    utf8,
    utf16
};

/** A data element: its type and its bytes. */
struct MatlabElement
{
    MatlabType type {};
    std::string_view data;
};

/** Four bytes as a number. @param bytes  4 or more [any] */
std::uint32_t matlabWord (std::string_view bytes, const MatlabForm&);

/** The next element, which is taken from the bytes. @throws InputError  when it is longer than they are [worker] */
MatlabElement takeElement (std::string_view& bytes, const MatlabForm&);

/** The numbers of an element. @throws InputError  when it has none [worker] */
std::vector<double> readNumbers (const MatlabElement&, const MatlabForm&);

/** Decompresses zlib data. Empty if it is damaged, or longer than this.
    @param maximum  bytes
    [worker] RFC 1950. */
std::optional<std::string> inflatedBytes (std::string_view packed, std::size_t maximum);
} // namespace antinode
