#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** Widths of a record's columns, which repeat to its end. */
using ColumnWidths = std::initializer_list<std::size_t>;

/** Appends the numbers of one record.

    They stand in columns of Fortran formats, but not every program keeps to them. So a record is read by its columns
   where every one holds a number, and else number by number: an exponent may begin with E or D or have no letter, and
   no blank need stand between numbers.
    @return  false when it has other things
    [any] */
bool appendRecordNumbers (std::string_view record, ColumnWidths, std::vector<double>&);

/** The records (lines) of a universal data set, read one after the other. The text must outlive it. [worker] */
class UniversalRecords
{
public:
    /** @param source     how errors name the file
        @param firstLine  the number of the first record in it, from 1 */
    UniversalRecords (std::string_view text, std::string source, std::size_t firstLine);

    /** True when nothing but blank lines is left. */
    bool atEnd() const;

    /** The number of bytes left: an upper bound for counts. */
    std::size_t bytesLeft() const { return text.size() - position; }

    /** The next record as it stands, without its line's end. @throws InputError  when there is none */
    std::string_view record();

    /** The next record as UTF-8 without the blanks around it; what is not UTF-8 is taken as Latin-1. */
    std::string textRecord();

    /** The next record's numbers. @throws InputError  when it has other things */
    std::vector<double> numbers (ColumnWidths);

    /** Appends the next record's numbers. */
    void appendNumbers (ColumnWidths, std::vector<double>&);

    /** The next record's first numbers, which must be whole; there may be more, and zeros stand for those that lack
        beyond `fewest`. */
    std::vector<std::int64_t> integers (std::size_t fewest, std::size_t count, std::size_t width = 10);

    /** A number of the last record that must be whole and fit into a column of ten characters, which nothing else may
       touch.
        @throws InputError  when it is not */
    std::int64_t whole (double number) const;

    /** @throws InputError  source, line of the last record, what is wrong. */
    [[noreturn]] void fail (const std::string& wrong) const;

private:
    std::string_view text;
    std::string source;
    std::size_t position = 0, line;
};

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
