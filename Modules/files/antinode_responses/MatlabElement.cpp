#include "MatlabElement.h"

#include <antinode_base/InputError.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <type_traits>

namespace antinode
{
namespace
{
constexpr std::size_t tagBytes = 8;

template <typename Integer>
Integer readInteger (std::string_view bytes, bool isBigEndian)
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

template <typename Stored>
std::vector<double> numbersAs (std::string_view data, bool isBigEndian)
{
    using Bits =
        std::conditional_t<sizeof (Stored) == 1, std::uint8_t,
                           std::conditional_t<sizeof (Stored) == 2, std::uint16_t,
                                              std::conditional_t<sizeof (Stored) == 4, std::uint32_t, std::uint64_t>>>;
    std::vector<double> numbers (data.size() / sizeof (Stored));

    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<double> (std::bit_cast<Stored> (
            readInteger<Bits> (data.substr (i * sizeof (Stored), sizeof (Stored)), isBigEndian)));

    return numbers;
}
} // namespace

void MatlabForm::failDamaged (const std::string& how) const
{
    throw InputError (source, "is damaged: " + how);
}

std::uint32_t matlabWord (std::string_view bytes, const MatlabForm& form)
{
    return readInteger<std::uint32_t> (bytes, form.isBigEndian);
}

MatlabElement takeElement (std::string_view& bytes, const MatlabForm& form)
{
    constexpr std::uint32_t shortType = 0xffff;

    if (bytes.size() < tagBytes)
        form.failDamaged ("an element ends too early");

    const auto first = matlabWord (bytes, form);

    if (const auto shortSize = first >> 16; shortSize != 0) // Up to four bytes stand in the tag.
    {
        constexpr std::size_t place = 4;

        if (shortSize > place)
            form.failDamaged ("a small element has more than four bytes");

        const MatlabElement element { static_cast<MatlabType> (first & shortType), bytes.substr (place, shortSize) };
        bytes.remove_prefix (tagBytes);
        return element;
    }

    const std::size_t size = matlabWord (bytes.substr (4), form);

    if (size > bytes.size() - tagBytes)
        form.failDamaged ("an element is longer than the file");

    const MatlabElement element { static_cast<MatlabType> (first), bytes.substr (tagBytes, size) };
    const auto padded = element.type == MatlabType::compressed ? size : (size + 7) / 8 * 8;
    bytes.remove_prefix (std::min (bytes.size(), tagBytes + padded));
    return element;
}

std::vector<double> readNumbers (const MatlabElement& element, const MatlabForm& form)
{
    const auto data = element.data;
    const auto big = form.isBigEndian;

    switch (element.type)
    {
        case MatlabType::int8:
            return numbersAs<std::int8_t> (data, big);
        case MatlabType::utf8:
        case MatlabType::uint8:
            return numbersAs<std::uint8_t> (data, big);
        case MatlabType::int16:
            return numbersAs<std::int16_t> (data, big);
        case MatlabType::utf16:
        case MatlabType::uint16:
            return numbersAs<std::uint16_t> (data, big);
        case MatlabType::int32:
            return numbersAs<std::int32_t> (data, big);
        case MatlabType::uint32:
            return numbersAs<std::uint32_t> (data, big);
        case MatlabType::single:
            return numbersAs<float> (data, big);
        case MatlabType::doublePrecision:
            return numbersAs<double> (data, big);
        case MatlabType::int64:
            return numbersAs<std::int64_t> (data, big);
        case MatlabType::uint64:
            return numbersAs<std::uint64_t> (data, big);
        default:
            form.failDamaged ("numbers are of the unknown type "
                              + std::to_string (static_cast<std::uint32_t> (element.type)));
    }
}

std::optional<std::string> inflatedBytes (std::string_view packed, std::size_t maximum)
{
    constexpr std::size_t step = 1 << 16;
    z_stream stream {};

    if (packed.size() > std::numeric_limits<uInt>::max() || inflateInit (&stream) != Z_OK)
        return std::nullopt;

    const std::unique_ptr<z_stream, int (*) (z_stream*)> closing (&stream, inflateEnd);
    std::string bytes;
    stream.next_in =
        reinterpret_cast<Bytef*> (const_cast<char*> (packed.data())); // zlib's interface: it is not written to.
    stream.avail_in = static_cast<uInt> (packed.size());

    while (true)
    {
        const auto before = bytes.size();
        const auto room = std::min (step, maximum - before);

        if (room == 0)
            return std::nullopt;

        bytes.resize (before + room);
        stream.next_out = reinterpret_cast<Bytef*> (bytes.data() + before);
        stream.avail_out = static_cast<uInt> (room);
        const auto status = inflate (&stream, Z_NO_FLUSH);
        bytes.resize (before + room - stream.avail_out);

        if (status == Z_STREAM_END)
            return bytes;

        if (status != Z_OK || bytes.size() == before)
            return std::nullopt;
    }
}
} // namespace antinode
