#include "MatlabFile.h"

#include "MatlabElement.h"

#include "UniversalRecords.h"
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t headerBytes = 128, elementTagBytes = 8;
constexpr int deepest = 6; ///< Structures and cells within each other.

constexpr std::uint32_t cellClass = 1, structureClass = 2, objectClass = 3, characterClass = 4, firstNumberClass = 6,
                        lastNumberClass = 15, opaqueClass = 17;

/** Where a file is read, and what was found. */
struct Reader
{
    MatlabForm form;
    std::size_t budget = 0; ///< Bytes that may still be unpacked.
    std::vector<MatlabVariable> variables;
};

/** Sizes of an array, of which the product is not more than its bytes can hold. */
std::vector<std::size_t> readSizes (const MatlabElement& element, std::size_t maximum, const MatlabForm& form)
{
    std::vector<std::size_t> sizes;
    std::size_t product = 1;

    for (const auto size : readNumbers (element, form))
    {
        if (! (size >= 0 && size <= static_cast<double> (maximum)))
            form.failDamaged ("an array is larger than the file");

        sizes.push_back (static_cast<std::size_t> (size));
        product = sizes.back() > 0 && product > maximum / sizes.back() ? maximum + 1 : product * sizes.back();

        if (product > maximum)
            form.failDamaged ("an array is larger than the file");
    }

    return sizes;
}

void addMatrix (std::string_view bytes, const std::string& prefix, int depth, Reader& reader);

/** "S" of one element, "S(2)" of several. */
std::string elementName (const std::string& name, std::size_t index, std::size_t count, char open, char close)
{
    return count == 1 ? name : name + open + std::to_string (index + 1) + close;
}

/** The fields of a structure, or of an array of them: each a matrix, element after element. */
void addFields (std::string_view bytes, const std::string& name, std::size_t count, int depth, Reader& reader)
{
    const auto lengths = readNumbers (takeElement (bytes, reader.form), reader.form);
    const auto names = takeElement (bytes, reader.form).data;

    if (lengths.size() != 1 || ! (lengths[0] >= 1 && lengths[0] <= static_cast<double> (names.size() + 1)))
        reader.form.failDamaged ("a structure does not list its fields");

    const auto length = static_cast<std::size_t> (lengths[0]);

    for (std::size_t i = 0; i < count && names.size() >= length; ++i)
        for (std::size_t at = 0; at + length <= names.size(); at += length)
        {
            const auto field = names.substr (at, length);
            const auto element = takeElement (bytes, reader.form);

            if (element.type == MatlabType::matrix)
                addMatrix (element.data,
                           elementName (name, i, count, '(', ')') + "."
                               + printable (field.substr (0, field.find ('\0'))),
                           depth + 1, reader);
        }
}

/** The cells of an array of them, each a matrix. */
void addCells (std::string_view bytes, const std::string& name, std::size_t count, int depth, Reader& reader)
{
    for (std::size_t i = 0; i < count; ++i)
        if (const auto element = takeElement (bytes, reader.form); element.type == MatlabType::matrix)
            addMatrix (element.data, elementName (name, i, count, '{', '}'), depth + 1, reader);
}

/** A character of 16 bits; others become '?'. */
void appendUtf8 (std::string& text, double code)
{
    const auto bits = code >= ' ' && code < 0x10000 ? static_cast<unsigned> (code) : '?';
    const auto append = [&text] (unsigned byte) { text += static_cast<char> (byte); };

    if (bits < 0x80)
        return append (bits);

    if (bits < 0x800)
        append (0xc0 | bits >> 6);
    else
    {
        append (0xe0 | bits >> 12);
        append (0x80 | (bits >> 6 & 0x3f));
    }

    append (0x80 | (bits & 0x3f));
}

void addText (MatlabVariable variable, const MatlabElement& element, Reader& reader)
{
    if (element.type == MatlabType::utf8)
        variable.text = trimmedText (element.data);
    else
        for (const auto code : readNumbers (element, reader.form))
            appendUtf8 (variable.text, code);

    variable.text = plainText (variable.text); // "m/s^2" where there is a raised 2.
    reader.variables.push_back (std::move (variable));
}

/** An object of a class: name, the system that stores it if it is opaque, class. */
void addObject (std::string_view bytes, const std::string& prefix, bool isOpaque, Reader& reader)
{
    MatlabVariable variable;
    const auto name = takeElement (bytes, reader.form).data;
    variable.name = prefix.empty() ? printable (name) : prefix;

    if (isOpaque)
        takeElement (bytes, reader.form);

    variable.className = printable (takeElement (bytes, reader.form).data);
    reader.variables.push_back (std::move (variable));
}

void addMatrix (std::string_view bytes, const std::string& prefix, int depth, Reader& reader)
{
    if (bytes.empty() || depth > deepest)
        return;

    const auto flags = takeElement (bytes, reader.form);

    if (flags.data.size() < 4)
        reader.form.failDamaged ("an array has no class");

    const auto word = matlabWord (flags.data, reader.form);
    const auto kind = word & 0xff;
    const auto isComplex = (word & 0x800) != 0;

    if (kind == opaqueClass)
        return addObject (bytes, prefix, true, reader);

    MatlabVariable variable;
    variable.sizes = readSizes (takeElement (bytes, reader.form), bytes.size(), reader.form);

    if (kind == objectClass)
        return addObject (bytes, prefix, false, reader);

    const auto name = takeElement (bytes, reader.form).data;
    variable.name = prefix.empty() ? printable (name) : prefix;
    std::size_t count = variable.sizes.size() < 2 ? 0 : 1;

    for (const auto size : variable.sizes)
        count *= size;

    if (kind == structureClass)
        return addFields (bytes, variable.name, count, depth, reader);

    if (kind == cellClass)
        return addCells (bytes, variable.name, count, depth, reader);

    if (kind == characterClass)
        return addText (std::move (variable), takeElement (bytes, reader.form), reader);

    if (kind < firstNumberClass || kind > lastNumberClass || count == 0)
        return;

    variable.real = readNumbers (takeElement (bytes, reader.form), reader.form);

    if (isComplex)
        variable.imaginary = readNumbers (takeElement (bytes, reader.form), reader.form);

    if (variable.real.size() != count || (isComplex && variable.imaginary.size() != count))
        reader.form.failDamaged ("variable " + inQuotes (variable.name)
                                 + " has a number of values that differs from its sizes");

    reader.variables.push_back (std::move (variable));
}

void addElement (const MatlabElement& element, Reader& reader)
{
    if (element.type == MatlabType::matrix)
        return addMatrix (element.data, {}, 0, reader);

    if (element.type != MatlabType::compressed)
        return;

    const auto unpacked = inflatedBytes (element.data, reader.budget);

    if (! unpacked)
        reader.form.failDamaged ("it cannot be decompressed, or expands to more than 16 times its size");

    reader.budget -= unpacked->size();
    std::string_view inner = *unpacked;

    if (const auto content = takeElement (inner, reader.form); content.type == MatlabType::matrix)
        addMatrix (content.data, {}, 0, reader);
}

constexpr std::size_t level4HeaderBytes = 20;

/** The five words before a matrix of level 4. */
struct Level4Header
{
    MatlabForm form;
    std::uint32_t precision = 0, kind = 0, isComplex = 0;
    std::size_t rows = 0, columns = 0, nameBytes = 0;
};

/** The header of a matrix of level 4 in either byte order; nothing if these bytes are none. */
std::optional<Level4Header> level4Header (std::string_view bytes, const std::string& source)
{
    constexpr std::uint32_t largestPrecision = 5, largestKind = 2, longestName = 64, thousand = 1000;

    if (bytes.size() < level4HeaderBytes)
        return std::nullopt;

    for (const auto isBigEndian : { false, true })
    {
        const MatlabForm form { source, isBigEndian };
        const auto word = [&] (std::size_t i) { return matlabWord (bytes.substr (4 * i), form); };
        const auto code = word (0);
        const Level4Header header { form, code / 10 % 10, code % 10, word (3), word (1), word (2), word (4) };
        const auto name = bytes.substr (level4HeaderBytes, header.nameBytes);

        if (code / thousand == (isBigEndian ? 1 : 0) && code / 100 % 10 == 0 && header.precision <= largestPrecision
            && header.kind <= largestKind && header.isComplex <= 1 && header.nameBytes > 1
            && header.nameBytes <= longestName && name.size() == header.nameBytes && name.find ('\0') == name.size() - 1
            && std::isalpha (static_cast<unsigned char> (name[0])) != 0)
            return header;
    }

    return std::nullopt;
}

/** Takes the numbers of a matrix, or of its imaginary part. */
std::vector<double> takeLevel4Numbers (std::string_view& bytes, const Level4Header& header)
{
    constexpr std::array types { std::pair { MatlabType::doublePrecision, 8 }, std::pair { MatlabType::single, 4 },
                                 std::pair { MatlabType::int32, 4 },           std::pair { MatlabType::int16, 2 },
                                 std::pair { MatlabType::uint16, 2 },          std::pair { MatlabType::uint8, 1 } };
    const auto [type, width] = types[header.precision];
    const auto available = bytes.size() / static_cast<std::size_t> (width);

    if (header.rows > 0 && header.columns > available / header.rows)
        header.form.failDamaged ("an array is larger than the file");

    const auto size = header.rows * header.columns * static_cast<std::size_t> (width);
    auto numbers = readNumbers ({ type, bytes.substr (0, size) }, header.form);
    bytes.remove_prefix (size);
    return numbers;
}

/** The matrices of a file of level 4, one after the other. */
std::vector<MatlabVariable> readLevel4 (std::string_view bytes, const std::string& source)
{
    constexpr std::uint32_t textKind = 1, sparseKind = 2;
    std::vector<MatlabVariable> variables;

    while (! bytes.empty())
    {
        const auto header = level4Header (bytes, source);

        if (! header)
            MatlabForm { source }.failDamaged ("other data follow its first matrices of version 4");

        MatlabVariable variable;
        variable.name = printable (bytes.substr (level4HeaderBytes, header->nameBytes - 1));
        variable.sizes = { header->rows, header->columns };
        bytes.remove_prefix (level4HeaderBytes + header->nameBytes);
        auto numbers = takeLevel4Numbers (bytes, *header);

        if (header->isComplex != 0)
            variable.imaginary = takeLevel4Numbers (bytes, *header);

        if (header->kind == textKind)
        {
            for (const auto code : numbers)
                appendUtf8 (variable.text, code);

            variable.text = plainText (variable.text);
            variable.imaginary.clear();
        }
        else
            variable.real = std::move (numbers);

        if (header->kind != sparseKind && header->rows * header->columns > 0)
            variables.push_back (std::move (variable));
    }

    return variables;
}

bool isBigEndianFile (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t versionPlace = 124, orderPlace = 126;

    if (bytes.starts_with ("\x89HDF") || bytes.starts_with ("MATLAB 7.3"))
        throw InputError (source, "is a MATLAB file of version 7.3; allowed: versions 4 to 7 (save it with '-v7')");

    const auto order = bytes.size() < headerBytes ? std::string_view {} : bytes.substr (orderPlace, 2);

    if (order != "IM" && order != "MI")
        throw InputError (source, "is not a MATLAB file of version 4 to 7");

    if (bytes.substr (versionPlace, 2) != (order == "MI" ? std::string_view ("\1\0", 2) : std::string_view ("\0\1", 2)))
        throw InputError (source,
                          "is a MATLAB file of an unknown version; allowed: versions 4 to 7 (save it with '-v7')");

    return order == "MI";
}
} // namespace

bool isMatlabLevel4 (std::string_view bytes)
{
    return level4Header (bytes, {}).has_value();
}

std::string shortName (const MatlabVariable& variable)
{
    auto name = variable.name.substr (variable.name.rfind ('.') + 1);
    name.resize (std::min (name.size(), name.find_first_of ("({"))); // Elements of arrays.
    std::transform (name.begin(), name.end(), name.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return name;
}

std::vector<MatlabVariable> readMatlabFile (std::string_view bytes, const std::string& source)
{
    if (isMatlabLevel4 (bytes))
        return readLevel4 (bytes, source);

    constexpr std::size_t unpackedShare = 16, minimumUnpackedBytes = 16 << 20;
    Reader reader { { source, isBigEndianFile (bytes, source) },
                    minimumUnpackedBytes + unpackedShare * bytes.size(),
                    {} };
    bytes.remove_prefix (headerBytes);

    while (bytes.size() >= elementTagBytes)
        addElement (takeElement (bytes, reader.form), reader);

    return reader.variables;
}
} // namespace antinode
