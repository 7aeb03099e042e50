#pragma once

#include <string>

namespace antinode
{
/** A field of a CSV file: in quotation marks where it holds a comma, a quotation mark or a line's end. [any] RFC 4180.
 */
std::string csvField (const std::string& text);

/** Appends a number with at most the given number of significant digits; 17 distinguish every double from its
   neighbours.
    @throws InputError  when it is not finite [any] */
void appendCsvNumber (std::string& text, double value, int significantDigits);
} // namespace antinode
