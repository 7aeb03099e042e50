#include "MatlabFile.h"

#include "InflatedBytes.h"
#include "MatlabElement.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <cstdint>
#include <optional>

namespace antinode
{
namespace
{
constexpr std::size_t headerBytes = 128, elementTagBytes = 8;
constexpr int deepest = 4; ///< Structures within structures.

constexpr std::uint32_t structureClass = 2, objectClass = 3, characterClass = 4, firstNumberClass = 6,
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

/** The fields of a structure of one element, each a matrix. */
void addFields (std::string_view bytes, const std::string& name, int depth, Reader& reader)
{
    const auto lengths = readNumbers (takeElement (bytes, reader.form), reader.form);
    const auto names = takeElement (bytes, reader.form).data;

    if (lengths.size() != 1 || ! (lengths[0] >= 1 && lengths[0] <= static_cast<double> (names.size() + 1)))
        reader.form.failDamaged ("a structure does not list its fields");

    const auto length = static_cast<std::size_t> (lengths[0]);

    for (std::size_t at = 0; at + length <= names.size(); at += length)
    {
        const auto field = names.substr (at, length);
        const auto element = takeElement (bytes, reader.form);

        if (element.type == MatlabType::matrix)
            addMatrix (element.data, name + "." + printable (field.substr (0, field.find ('\0'))), depth + 1, reader);
    }
}

void addText (MatlabVariable variable, const MatlabElement& element, Reader& reader)
{
    for (const auto code : readNumbers (element, reader.form))
        variable.text += code >= ' ' && code < 0x7f ? static_cast<char> (code)
                         : code == 0xb2             ? '2'
                                                    : '?'; // A raised 2 as in m/s2.

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

    if (kind == structureClass && count == 1)
        return addFields (bytes, variable.name, depth, reader);

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

bool isBigEndianFile (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t versionPlace = 124, orderPlace = 126;

    if (bytes.starts_with ("\x89HDF") || bytes.starts_with ("MATLAB 7.3"))
        throw InputError (source, "is a MATLAB file of version 7.3; allowed: versions 5 to 7 (save it with '-v7')");

    const auto order = bytes.size() < headerBytes ? std::string_view {} : bytes.substr (orderPlace, 2);

    if (order != "IM" && order != "MI")
        throw InputError (source, "is not a MATLAB file of version 5 to 7");

    if (bytes.substr (versionPlace, 2) != (order == "MI" ? std::string_view ("\1\0", 2) : std::string_view ("\0\1", 2)))
        throw InputError (source,
                          "is a MATLAB file of an unknown version; allowed: versions 5 to 7 (save it with '-v7')");

    return order == "MI";
}
} // namespace

std::vector<MatlabVariable> readMatlabFile (std::string_view bytes, const std::string& source)
{
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
