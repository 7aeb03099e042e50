#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
// Columns of universal data sets as Fortran writes them: right-justified, reals as 1PE.

/** Appends a field at the right of its column; what is wider is not cut. [any] */
void appendRight (std::string& text, std::string_view field, std::size_t width);

/** Appends I10 or another width. [any] */
void appendInteger (std::string& text, std::int64_t number, std::size_t width = 10);

/** Appends a real in a column of E13.5: in that form where it is exact, else with as many digits as 12 characters hold,
    6 to 11, which Fortran reads too. @throws InputError  when it is not finite [any] */
void appendReal (std::string& text, double number);

/** Appends a real in a column of this width with the given number of digits behind the point; `letter` begins the
   exponent.
    @throws InputError  when it is not finite [any] */
void appendReal (std::string& text, double number, std::size_t width, int digits, char letter);

/** Records with the given number of fields each, appended by `append (text, item)`. [any] */
template <typename Items, typename Append>
void appendRecords (std::string& text, const Items& items, std::size_t aRecord, Append&& append)
{
    std::size_t count = 0;

    for (const auto& item : items)
    {
        append (text, item);

        if (++count % aRecord == 0)
            text += '\n';
    }

    if (count % aRecord != 0)
        text += '\n';
}

/** One record of integers, I10. [any] */
std::string integerRecord (const std::vector<std::int64_t>& numbers);

/** One record of reals in columns of E13.5. @throws InputError  when one is not finite [any] */
std::string realRecord (const std::vector<double>& numbers);

/** Text as a field or record has it: printable ASCII, at most `length` characters. Exponents and a few signs that units
   have are spelt out; any other character that is not ASCII becomes '?'. [any] */
std::string plainText (std::string_view text, std::size_t length = 80);

/** A record of text of at most 80 columns. [any] */
std::string textRecord (std::string_view text);
} // namespace antinode
