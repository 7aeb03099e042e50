#pragma once

#include "UniversalNumbers.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
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
} // namespace antinode
