#include "TypedNumber.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
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
