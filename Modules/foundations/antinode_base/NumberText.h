#pragma once

#include <string>

namespace antinode
{
/** Text as std::printf makes it, in the C locale of a program that sets none. [any] */
[[gnu::format (printf, 1, 2)]] std::string formatted (const char* format, ...);

/** A number with so many decimals: 0.5 with 2 is "0.50". [any] */
std::string fixedText (double value, int decimals);

/** A number as a person would write it: four significant digits, no exponent where it can be avoided. [any] */
std::string inWords (double value);
} // namespace antinode
