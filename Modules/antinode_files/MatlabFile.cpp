#include "MatlabFile.h"

#include "InflatedBytes.h"
#include "MessageText.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace antinode
{
namespace
{
constexpr std::size_t headerBytes = 128, tagBytes = 8;
constexpr int deepest = 4; ///< Structures within structures.

/** Types of data elements and classes of arrays, by the format's numbers. */
enum ElementType : std::uint32_t
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

constexpr std::uint32_t structureClass = 2, characterClass = 4, firstNumberClass = 6, lastNumberClass = 15;

/** A data element: its type and its bytes. */
struct Element
{
    std::uint32_t type = 0;
    std::string_view data;
};

/** Where a file is read, and what holds for all of it. */
struct Reader
{
    const std::string& source;
    bool isBigEndian = false;
    std::size_t budget = 0; ///< Bytes that may still be unpacked.
    std::vector<MatlabVariable> variables;

    [[noreturn]] void failDamaged (const std::string& what) const { throw InputError (source, "is damaged: " + what); }
};

template <typename Integer>
Integer integerOf (std::string_view bytes, bool isBigEndian)
{
    Integer value = 0;

    for (std::size_t i = 0; i < sizeof (Integer); ++i)
    {
        const auto place = isBigEndian ? sizeof (Integer) - 1 - i : i;
        value =
            static_cast<Integer> (value | static_cast<Integer> (static_cast<unsigned char> (bytes[i])) << 8 * place);
    }

    return value;
}

/** The next element, which is taken from the bytes. */
Element takeElement (std::string_view& bytes, const Reader& reader)
{
    constexpr std::uint32_t shortType = 0xffff;

    if (bytes.size() < tagBytes)
        reader.failDamaged ("an element ends too early");

    const auto first = integerOf<std::uint32_t> (bytes, reader.isBigEndian);

    if (const auto shortSize = first >> 16; shortSize != 0) // Up to four bytes stand in the tag.
    {
        constexpr std::size_t place = 4;

        if (shortSize > place)
            reader.failDamaged ("a small element has more than four bytes");

        const Element element { first & shortType, bytes.substr (place, shortSize) };
        bytes.remove_prefix (tagBytes);
        return element;
    }

    const std::size_t size = integerOf<std::uint32_t> (bytes.substr (4), reader.isBigEndian);

    if (size > bytes.size() - tagBytes)
        reader.failDamaged ("an element is longer than the file");

    const Element element { first, bytes.substr (tagBytes, size) };
    const auto padded = first == compressed ? size : (size + 7) / 8 * 8;
    bytes.remove_prefix (std::min (bytes.size(), tagBytes + padded));
    return element;
}

template <typename Stored>
std::vector<double> numbersAs (std::string_view data, bool isBigEndian)
{
    using Bits =
        std::conditional_t<sizeof (Stored) == 1, std::uint8_t,
                           std::conditional_t<sizeof (Stored) == 2, std::uint16_t,
                                              std::conditional_t<sizeof (Stored) == 4, std::uint32_t, std::uint64_t>>>;
    std::vector<double> numbers (data.size() / sizeof (Stored));

    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<double> (
            std::bit_cast<Stored> (integerOf<Bits> (data.substr (i * sizeof (Stored), sizeof (Stored)), isBigEndian)));

    return numbers;
}

std::vector<double> numbersOf (const Element& element, const Reader& reader)
{
    const auto data = element.data;
    const auto big = reader.isBigEndian;

    switch (element.type)
    {
        case int8:
            return numbersAs<std::int8_t> (data, big);
        case utf8:
        case uint8:
            return numbersAs<std::uint8_t> (data, big);
        case int16:
            return numbersAs<std::int16_t> (data, big);
        case utf16:
        case uint16:
            return numbersAs<std::uint16_t> (data, big);
        case int32:
            return numbersAs<std::int32_t> (data, big);
        case uint32:
            return numbersAs<std::uint32_t> (data, big);
        case single:
            return numbersAs<float> (data, big);
        case doublePrecision:
            return numbersAs<double> (data, big);
        case int64:
            return numbersAs<std::int64_t> (data, big);
        case uint64:
            return numbersAs<std::uint64_t> (data, big);
        default:
            reader.failDamaged ("numbers have the unknown type " + std::to_string (element.type));
    }
}

/** Sizes of an array, of which the product is not more than its bytes can hold. */
std::vector<std::size_t> sizesOf (const Element& element, std::size_t most, const Reader& reader)
{
    std::vector<std::size_t> sizes;
    std::size_t product = 1;

    for (const auto size : numbersOf (element, reader))
    {
        if (! (size >= 0 && size <= static_cast<double> (most)))
            reader.failDamaged ("an array is larger than the file");

        sizes.push_back (static_cast<std::size_t> (size));
        product = sizes.back() > 0 && product > most / sizes.back() ? most + 1 : product * sizes.back();

        if (product > most)
            reader.failDamaged ("an array is larger than the file");
    }

    return sizes;
}

void addMatrix (std::string_view bytes, const std::string& prefix, int depth, Reader& reader);

/** The fields of a structure of one element, each a matrix. */
void addFields (std::string_view bytes, const std::string& name, int depth, Reader& reader)
{
    const auto lengths = numbersOf (takeElement (bytes, reader), reader);
    const auto names = takeElement (bytes, reader).data;

    if (lengths.size() != 1 || ! (lengths[0] >= 1 && lengths[0] <= static_cast<double> (names.size() + 1)))
        reader.failDamaged ("a structure does not tell its fields");

    const auto length = static_cast<std::size_t> (lengths[0]);

    for (std::size_t at = 0; at + length <= names.size(); at += length)
    {
        const auto field = names.substr (at, length);
        const auto element = takeElement (bytes, reader);

        if (element.type == matrix)
            addMatrix (element.data, name + "." + printable (field.substr (0, field.find ('\0'))), depth + 1, reader);
    }
}

void addText (MatlabVariable variable, const Element& element, Reader& reader)
{
    for (const auto code : numbersOf (element, reader))
        variable.text += code >= ' ' && code < 0x7f ? static_cast<char> (code)
                         : code == 0xb2             ? '2'
                                                    : '?'; // A raised 2 as in m/s2.

    reader.variables.push_back (std::move (variable));
}

void addMatrix (std::string_view bytes, const std::string& prefix, int depth, Reader& reader)
{
    if (bytes.empty() || depth > deepest)
        return;

    const auto flags = takeElement (bytes, reader);

    if (flags.data.size() < 4)
        reader.failDamaged ("an array does not tell its class");

    const auto word = integerOf<std::uint32_t> (flags.data, reader.isBigEndian);
    const auto kind = word & 0xff;
    const auto isComplex = (word & 0x800) != 0;
    MatlabVariable variable;
    variable.sizes = sizesOf (takeElement (bytes, reader), bytes.size(), reader);
    const auto name = takeElement (bytes, reader).data;
    variable.name = prefix.empty() ? printable (name) : prefix;
    std::size_t count = variable.sizes.size() < 2 ? 0 : 1;

    for (const auto size : variable.sizes)
        count *= size;

    if (kind == structureClass && count == 1)
        return addFields (bytes, variable.name, depth, reader);

    if (kind == characterClass)
        return addText (std::move (variable), takeElement (bytes, reader), reader);

    if (kind < firstNumberClass || kind > lastNumberClass || count == 0)
        return;

    variable.real = numbersOf (takeElement (bytes, reader), reader);

    if (isComplex)
        variable.imaginary = numbersOf (takeElement (bytes, reader), reader);

    if (variable.real.size() != count || (isComplex && variable.imaginary.size() != count))
        reader.failDamaged ("variable " + inQuotes (variable.name) + " has not as many numbers as its sizes say");

    reader.variables.push_back (std::move (variable));
}

void addElement (const Element& element, Reader& reader)
{
    if (element.type == matrix)
        return addMatrix (element.data, {}, 0, reader);

    if (element.type != compressed)
        return;

    const auto unpacked = inflatedBytes (element.data, reader.budget);

    if (! unpacked)
        reader.failDamaged ("it cannot be unpacked, or to more than 16 times its size");

    reader.budget -= unpacked->size();
    std::string_view inner = *unpacked;

    if (const auto content = takeElement (inner, reader); content.type == matrix)
        addMatrix (content.data, {}, 0, reader);
}

bool isBigEndianFile (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t versionPlace = 124, orderPlace = 126;

    if (bytes.starts_with ("\x89HDF") || bytes.starts_with ("MATLAB 7.3"))
        throw InputError (source, "is a MATLAB file of version 7.3, allowed are versions 5 to 7: save it with '-v7'");

    const auto order = bytes.size() < headerBytes ? std::string_view {} : bytes.substr (orderPlace, 2);

    if (order != "IM" && order != "MI")
        throw InputError (source, "is not a MATLAB file of version 5 to 7");

    if (integerOf<std::uint16_t> (bytes.substr (versionPlace), order == "MI") != 0x0100)
        throw InputError (source, "is a MATLAB file of another version, allowed are 5 to 7: save it with '-v7'");

    return order == "MI";
}
} // namespace

std::vector<MatlabVariable> readMatlabFile (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t unpackedShare = 16, unpackedLeast = 16 << 20;
    Reader reader { source, isBigEndianFile (bytes, source), unpackedLeast + unpackedShare * bytes.size(), {} };
    bytes.remove_prefix (headerBytes);

    while (bytes.size() >= tagBytes)
        addElement (takeElement (bytes, reader), reader);

    return reader.variables;
}
} // namespace antinode
