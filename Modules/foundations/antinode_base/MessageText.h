#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** True when all bytes form valid UTF-8 (no overlong forms, no surrogates, nothing beyond U+10FFFF). [any] */
bool isUtf8 (std::string_view text);

/** External text made printable on one line of a message: control characters, line separators and bytes that are not
   UTF-8 become '?', and what is longer than maximumLength bytes is cut and ends in "...". [any] */
std::string printable (std::string_view text, std::size_t maximumLength = 60);

/** The printable text between single quotation marks. [any] */
std::string inQuotes (std::string_view text);

/** Words as 'a', 'b', 'c'. [any] */
std::string listed (const std::vector<std::string_view>& words);

/** A number for messages: 12 significant digits, or as many as distinguish it from its neighbours. [any] */
std::string numberText (double value);

/** The most likely candidate for a misspelt word, as " (did you mean 'x'?)"; empty if none is close. [any] */
std::string didYouMean (std::string_view word, const std::vector<std::string_view>& candidates);

/** Text of unknown encoding as UTF-8, without the blanks around it; bytes that are not UTF-8 are read as Latin-1. [any]
 */
std::string trimmedText (std::string_view);

/** Text as std::printf makes it, in the C locale of a program that sets none. [any] */
[[gnu::format (printf, 1, 2)]] std::string formatted (const char* format, ...);

/** A number with so many decimals: 0.5 with 2 is "0.50". [any] */
std::string fixedText (double value, int decimals);

/** A number as a person would write it: four significant digits, no exponent where it can be avoided. [any] */
std::string inWords (double value);

/** A number as a person types it, with a decimal point or a decimal comma, and a unit or none: "0.5", "0,5", " -3 mm".
    @param units  what may stand behind it; whether letters are small does not matter, a micro sign may be a u
    @return       none where the text says anything else, or no finite number [any] */
std::optional<double> typedNumber (std::string_view text, std::initializer_list<std::string_view> units = {});
} // namespace antinode
