#include "UniversalRecordText.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> spellings { {
    { "\xc2\xb9", "^1" },
    { "\xc2\xb2", "^2" },
    { "\xc2\xb3", "^3" },
    { "\xe2\x81\xbb", "^-" },
    { "\xe2\x88\x92", "-" },
    { "\xe2\x80\x99", "'" },
    { "\xe2\x8b\x85", "*" },
    { "\xe2\x88\x99", "*" },
    { "\xc3\x97", "*" },
    { "\xc2\xa0", " " },
    { "\xc2\xba", "deg" },
    { "\xc2\xb5", "u" },
    { "\xce\xbc", "u" },
    { "\xc2\xb7", "*" },
    { "\xc2\xb0", "deg" },
} };

constexpr std::size_t realWidth = 13;
constexpr int realDigits = 5;
constexpr double smallestReal = 1e-99; // An exponent of three digits leaves no space between two columns.

double parsed (const std::string& field)
{
    double value = 0;
    std::from_chars (field.data(), field.data() + field.size(), value);
    return value;
}

/** At most so many characters, with as many digits as they hold: any form with a point may stand in a column of E13.5.
 */
std::string closest (double number, std::size_t characters)
{
    constexpr double fixedFrom = 1e-3, fixedTo = 1e9;
    constexpr int mostDigits = 11;
    const auto isFixed = std::abs (number) >= fixedFrom && std::abs (number) < fixedTo;
    const auto fewestDigits = isFixed ? 1 : realDigits;
    std::array<char, 48> buffer {};

    if (! std::isfinite (number) || std::abs (number) < smallestReal)
        return {};

    for (auto digits = mostDigits; digits >= fewestDigits; --digits)
    {
        const auto written = std::to_chars (buffer.data(), buffer.data() + buffer.size(), number,
                                            isFixed ? std::chars_format::fixed : std::chars_format::scientific, digits);
        std::string field (buffer.data(), written.ptr);

        if (const auto exponent = field.find ("e-0"); exponent != std::string::npos)
            field.erase (exponent + 2, 1);
        else if (const auto positive = field.find ("e+"); positive != std::string::npos)
            field.erase (positive + 1, field[positive + 2] == '0' ? 2 : 1);

        if (field.size() <= characters)
            return field;
    }

    return {};
}
} // namespace

void appendRight (std::string& text, std::string_view field, std::size_t width)
{
    text.append (width - std::min (width, field.size()), ' ');
    text += field;
}

void appendInteger (std::string& text, std::int64_t number, std::size_t width)
{
    appendRight (text, std::to_string (number), width);
}

void appendReal (std::string& text, double number)
{
    const auto longer = closest (number, realWidth - 1);
    std::string standard;
    appendReal (standard, longer.empty() ? number : parsed (longer), realWidth, realDigits, 'E');
    const auto isExact =
        longer.empty() || parsed (standard.substr (standard.find_first_not_of (' '))) == parsed (longer);

    if (isExact)
        text += standard;
    else
    {
        auto field = longer;
        std::replace (field.begin(), field.end(), 'e', 'E');
        appendRight (text, field, realWidth);
    }
}

void appendReal (std::string& text, double number, std::size_t width, int digits, char letter)
{
    std::array<char, 48> buffer {};

    if (! std::isfinite (number))
        throw InputError ("universal file", "has a value that is not finite");

    const auto written =
        std::to_chars (buffer.data(), buffer.data() + buffer.size(), std::abs (number) < smallestReal ? 0.0 : number,
                       std::chars_format::scientific, digits);
    std::string field (buffer.data(), written.ptr);
    std::replace (field.begin(), field.end(), 'e', letter);
    appendRight (text, field, width);
}

std::string integerRecord (const std::vector<std::int64_t>& numbers)
{
    std::string text;

    for (const auto number : numbers)
        appendInteger (text, number);

    return text + '\n';
}

std::string realRecord (const std::vector<double>& numbers)
{
    std::string text;

    for (const auto number : numbers)
        appendReal (text, number);

    return text + '\n';
}

std::string plainText (std::string_view text, std::size_t length)
{
    std::string plain;

    while (! text.empty())
    {
        const auto spelling = std::find_if (spellings.begin(), spellings.end(),
                                            [&] (const auto& pair) { return text.starts_with (pair.first); });

        if (spelling != spellings.end())
        {
            plain += spelling->second;
            text.remove_prefix (spelling->first.size());
            continue;
        }

        const auto byte = static_cast<unsigned char> (text.front());
        const auto isContinuation = byte >= 0x80 && byte < 0xc0;
        text.remove_prefix (1);

        if (! isContinuation)
            plain += byte >= ' ' && byte < 0x7f ? static_cast<char> (byte) : '?';
    }

    if (plain.size() > length) // What blanks are left at its end would not be read again.
        plain.resize (plain.find_last_not_of (' ', length - 1) + 1);

    return plain;
}

std::string textRecord (std::string_view text)
{
    const auto plain = plainText (text);
    return (plain == "    -1" ? "-1" : plain) + '\n'; // In these columns it would close the set.
}
} // namespace antinode
