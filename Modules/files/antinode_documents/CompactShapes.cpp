#include "CompactShapes.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace antinode
{
namespace
{
constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr Eigen::Index bytesPerNumber = 4;
constexpr std::size_t bytesOf3 = 3, digitsOf3 = 4; // Three bytes are four digits of six bits.

std::string bytesOf (const Eigen::VectorXd& numbers)
{
    std::string bytes;
    bytes.reserve (static_cast<std::size_t> (bytesPerNumber * numbers.size()));

    for (const auto number : numbers)
    {
        const auto bits = std::bit_cast<std::uint32_t> (static_cast<float> (number));

        for (unsigned shift = 0; shift < 32; shift += 8)
            bytes += static_cast<char> (bits >> shift & 0xffU);
    }

    return bytes;
}

/** -1 of a letter that is no digit. */
std::array<int, 256> digitValues()
{
    std::array<int, 256> values {};
    values.fill (-1);

    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char> (digits[i])] = static_cast<int> (i);

    return values;
}
} // namespace

std::string compactNumbers (const Eigen::VectorXd& numbers)
{
    const auto bytes = bytesOf (numbers);
    std::string text;
    text.reserve (digitsOf3 * (bytes.size() / bytesOf3 + 1));

    for (std::size_t i = 0; i < bytes.size(); i += bytesOf3)
    {
        std::uint32_t three = 0;

        for (std::size_t j = 0; j < bytesOf3; ++j)
            three = three << 8U | (i + j < bytes.size() ? static_cast<unsigned char> (bytes[i + j]) : 0U);

        for (std::size_t j = 0; j < digitsOf3; ++j)
            text += i + j <= bytes.size() ? digits[three >> (18 - 6 * j) & 63U] : '=';
    }

    return text;
}

Eigen::VectorXd readCompactNumbers (const JsonValue& value, Eigen::Index count)
{
    static const auto values = digitValues();
    const auto byteCount = static_cast<std::size_t> (bytesPerNumber * count);
    const auto length = digitsOf3 * ((byteCount + bytesOf3 - 1) / bytesOf3);
    const auto text = value.text (length);
    const auto fail = [&]
    {
        value.fail ("is no text of " + std::to_string (count)
                    + " numbers of 4 bytes; allowed: base64 of finite little-endian numbers of 4 bytes, or a list");
    };

    if (text.size() != length)
        fail();

    std::string bytes;
    std::uint32_t bits = 0;
    int known = 0;

    for (std::size_t i = 0; i < text.size() && bytes.size() < byteCount; ++i)
    {
        const auto digit = values[static_cast<unsigned char> (text[i])];

        if (digit < 0)
            fail();

        bits = bits << 6U | static_cast<std::uint32_t> (digit);
        known += 6;

        if (known >= 8)
            bytes += static_cast<char> (bits >> static_cast<unsigned> (known -= 8) & 0xffU);
    }

    Eigen::VectorXd numbers (count);

    for (Eigen::Index k = 0; k < count; ++k)
    {
        std::uint32_t number = 0;

        for (Eigen::Index j = bytesPerNumber; j-- > 0;)
            number =
                number << 8U | static_cast<unsigned char> (bytes[static_cast<std::size_t> (bytesPerNumber * k + j)]);

        numbers[k] = std::bit_cast<float> (number);

        if (! std::isfinite (numbers[k]))
            fail();
    }

    return numbers;
}
} // namespace antinode
