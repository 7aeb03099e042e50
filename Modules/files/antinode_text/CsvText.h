#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A field of a CSV file: in quotation marks where it holds a comma, a quotation mark or a line's end. [any] RFC 4180.
 */
std::string csvField (const std::string& text);

/** Appends a number with at most the given number of significant digits; 17 distinguish every double from its
   neighbours.
    @throws InputError  when it is not finite [any] */
void appendCsvNumber (std::string& text, double value, int significantDigits);

/** A line of a table. */
struct CsvLine
{
    std::string_view text;
    std::size_t number = 0; ///< From 1.
};

/** Text in UTF-16, of either byte order, as UTF-8; other text as it is. [any] */
std::string csvText (std::string_view bytes);

/** The lines that are not blank, without a byte order mark; they end in LF, CR LF or CR. [any] */
std::vector<CsvLine> csvLines (std::string_view text);

/** Without blanks and quotation marks at both ends. [any] */
std::string_view csvStripped (std::string_view);

/** How many characters mark a line as a comment: those of #, %, ! or //, else 0. [any] */
std::size_t csvCommentMark (std::string_view line);

/** What separates cells, as a line of numbers shows: ; tab , or a blank. A comma that digits follow is the decimal sign
    where blanks separate. [any] */
char csvSeparator (std::string_view line);

/** The stripped cells of a line; separators between quotation marks do not count, nor commas between round brackets
   that belong together. [any] */
std::vector<std::string_view> csvCells (std::string_view line, char separator);

/** The number of a cell, with a point or, where commas do not separate, a comma; a time of the day, with a date before
   it or without, in seconds; NaN where the cell is empty, infinite or says that it has no number; nothing if it is
   something else. [any] */
std::optional<double> csvNumber (std::string_view cell, char separator);

/** The complex number of a cell: "1.5-2i", "(1.5,-2)", "1.5 - j2", "-2j"; nothing if it is something else. [any] */
std::optional<std::complex<double>> csvComplex (std::string_view cell, char separator);

/** Whether a cell is a date without a time: "2026-11-28", "28.11.2026", "11/28/2026". [any] */
bool isCsvDate (std::string_view cell);
} // namespace antinode
