#include "CsvText.h"

#include <antinode_base/InputError.h>

#include <array>
#include <charconv>
#include <cmath>

namespace antinode
{
std::string csvField (const std::string& text)
{
    if (text.find_first_of (",\"\r\n") == std::string::npos)
        return text;

    std::string quotedText = "\"";

    for (const auto character : text)
        quotedText += character == '"' ? std::string ("\"\"") : std::string (1, character);

    return quotedText + '"';
}

void appendCsvNumber (std::string& text, double value, int significantDigits)
{
    std::array<char, 32> buffer {};

    if (! std::isfinite (value))
        throw InputError ("CSV", "has a value that is not finite");

    const auto written = std::to_chars (buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general,
                                        significantDigits);
    text.append (buffer.data(), written.ptr);
}
} // namespace antinode
