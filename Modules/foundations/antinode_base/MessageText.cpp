#include "MessageText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numeric>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
/** One decoded character: how many bytes it takes and which it is; no bytes where they are not UTF-8. */
struct Character
{
    std::size_t bytes = 0;
    char32_t code = 0;
};

Character characterAt (std::string_view text, std::size_t begin)
{
    const auto first = static_cast<unsigned char> (text[begin]);

    if (first < 0x80)
        return { 1, first };

    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;

    if (first < 0xc2 || first > 0xf4 || begin + bytes > text.size())
        return {};

    auto code = static_cast<char32_t> (first & (0x7f >> bytes));

    for (auto i = begin + 1; i < begin + bytes; ++i)
    {
        const auto next = static_cast<unsigned char> (text[i]);

        if ((next & 0xc0) != 0x80)
            return {};

        code = code << 6 | (next & 0x3f);
    }

    const auto overlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
    const auto surrogate = code >= 0xd800 && code <= 0xdfff;
    return overlong || surrogate || code > 0x10ffff ? Character {} : Character { bytes, code };
}

bool breaksLine (char32_t code)
{
    return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x2028 || code == 0x2029;
}

/** Levenshtein's distance: the fewest insertions, deletions and replacements between two words. */
std::size_t editDistance (std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row (b.size() + 1);
    std::iota (row.begin(), row.end(), std::size_t { 0 });

    for (std::size_t i = 0; i < a.size(); ++i)
    {
        auto diagonal = row[0]++;

        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const auto replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min ({ replaced, row[j] + 1, diagonal + 1 });
        }
    }

    return row.back();
}

std::string_view trimmed (std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\f\v";
    const auto begin = text.find_first_not_of (blanks);
    return begin == std::string_view::npos ? std::string_view {}
                                           : text.substr (begin, text.find_last_not_of (blanks) - begin + 1);
}
} // namespace

bool isUtf8 (std::string_view text)
{
    for (std::size_t i = 0; i < text.size();)
    {
        const auto bytes = characterAt (text, i).bytes;

        if (bytes == 0)
            return false;

        i += bytes;
    }

    return true;
}

std::string printable (std::string_view text, std::size_t maximumLength)
{
    std::string result;

    for (std::size_t i = 0; i < text.size();)
    {
        const auto character = characterAt (text, i);
        const auto bytes = std::max<std::size_t> (character.bytes, 1);

        if (result.size() + bytes > maximumLength)
            return result + "...";

        if (character.bytes == 0 || breaksLine (character.code))
            result += '?';
        else
            result += text.substr (i, bytes);

        i += bytes;
    }

    return result;
}

std::string inQuotes (std::string_view text)
{
    return '\'' + printable (text) + '\'';
}

std::string listed (const std::vector<std::string_view>& words)
{
    std::string result;

    for (const auto word : words)
        result += (result.empty() ? "" : ", ") + inQuotes (word);

    return result;
}

std::string numberText (double value)
{
    std::array<char, 40> buffer {};
    auto* const begin = buffer.data();
    auto* const end = begin + buffer.size();
    auto written = std::to_chars (begin, end, value, std::chars_format::general, 12);
    double readBack = 0;
    std::from_chars (begin, written.ptr, readBack);

    if (readBack != value)
        written = std::to_chars (begin, end, value);

    return { begin, written.ptr };
}

std::string didYouMean (std::string_view word, const std::vector<std::string_view>& candidates)
{
    constexpr std::size_t longestWord = 100;
    std::string_view best;
    auto smallest = std::max<std::size_t> (word.size() / 3, 1) + 1;

    if (word.empty() || word.size() > longestWord)
        return {};

    // A word that only lacks its end, most often the unit, is as close as one with a letter amiss.
    for (const auto candidate : candidates)
        if (const auto distance = candidate.starts_with (word) ? 1 : editDistance (word, candidate);
            distance < smallest)
        {
            smallest = distance;
            best = candidate;
        }

    return best.empty() ? std::string {} : " (did you mean " + inQuotes (best) + "?)";
}
std::string trimmedText (std::string_view text)
{
    const auto bytes = trimmed (text);

    if (isUtf8 (bytes))
        return std::string (bytes);

    std::string converted;

    for (const auto byte : bytes)
        if (const auto code = static_cast<unsigned char> (byte); code < 0x80)
            converted += byte;
        else
        {
            converted += static_cast<char> (0xc0 | code >> 6);
            converted += static_cast<char> (0x80 | (code & 0x3f));
        }

    return converted;
}

std::string formatted (const char* format, ...)
{
    std::va_list arguments, again;
    va_start (arguments, format);
    va_copy (again, arguments);
    std::string text (static_cast<std::size_t> (std::vsnprintf (nullptr, 0, format, arguments)), ' ');
    va_end (arguments);
    std::vsnprintf (text.data(), text.size() + 1, format, again);
    va_end (again);
    return text;
}

std::string fixedText (double value, int decimals)
{
    auto text = formatted ("%.*f", decimals, value);

    // Zero has no sign.
    if (text.front() == '-' && text.find_first_of ("123456789") == std::string::npos)
        text.erase (0, 1);

    return text;
}

std::string inWords (double value)
{
    std::array<char, 32> text {};
    std::snprintf (text.data(), text.size(), std::abs (value) >= 1000 && std::abs (value) < 1e7 ? "%.0f" : "%.4g",
                   value);
    return text.data();
}

namespace
{
/** Without spaces around it, in small letters, with u for the micro sign and the Greek letter, and a plain minus. */
std::string plainText (std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 3> letters {
        { { "\xC2\xB5", "u" }, { "\xCE\xBC", "u" }, { "\xE2\x88\x92", "-" } }
    };
    const auto isSpace = [] (char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };

    while (! text.empty() && isSpace (text.front()))
        text.remove_prefix (1);

    while (! text.empty() && isSpace (text.back()))
        text.remove_suffix (1);

    std::string plain (text);

    for (const auto& [letter, plainer] : letters)
        for (auto at = plain.find (letter); at != std::string::npos; at = plain.find (letter))
            plain.replace (at, letter.size(), plainer);

    std::transform (plain.begin(), plain.end(), plain.begin(),
                    [] (char c) { return c >= 'A' && c <= 'Z' ? static_cast<char> (c - 'A' + 'a') : c; });
    return plain;
}
} // namespace

std::optional<double> typedNumber (std::string_view text, std::initializer_list<std::string_view> units)
{
    auto plain = plainText (text);
    const auto first = plain.find_first_of ("0123456789.,");

    // No words for infinity, and one sign at most.
    if (first > 1 || (first == 1 && plain.front() != '-' && plain.front() != '+'))
        return {};

    plain.erase (0, first == 1 && plain.front() == '+' ? 1 : 0);
    std::replace (plain.begin(), plain.end(), ',', '.');
    double value = 0;
    const auto [next, error] = std::from_chars (plain.data(), plain.data() + plain.size(), value);
    const auto rest = plainText ({ next, plain.data() + plain.size() });

    if (error != std::errc() || ! std::isfinite (value)
        || ! (rest.empty()
              || std::any_of (units.begin(), units.end(),
                              [&] (std::string_view unit) { return plainText (unit) == rest; })))
        return {};

    return value;
}
} // namespace antinode
