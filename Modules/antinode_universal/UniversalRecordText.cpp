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
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings { {
    { "\xc2\xb2", "^2" },
    { "\xc2\xb3", "^3" },
    { "\xc2\xb5", "u" },
    { "\xce\xbc", "u" },
    { "\xc2\xb7", "*" },
    { "\xc2\xb0", "deg" },
} };
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
    appendReal (text, number, 13, 5, 'E');
}

void appendReal (std::string& text, double number, std::size_t width, int digits, char letter)
{
    constexpr double smallest = 1e-99; // An exponent of three digits leaves no space between two columns.
    std::array<char, 48> buffer {};

    if (! std::isfinite (number))
        throw InputError ("universal file", "has a value that is not finite");

    const auto written =
        std::to_chars (buffer.data(), buffer.data() + buffer.size(), std::abs (number) < smallest ? 0.0 : number,
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
