#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace antinode
{
/** A line of a table. */
struct CsvLine
{
    std::string_view text;
    std::size_t number = 0; ///< From 1.
};

/** The lines that are not blank, without a byte order mark; they end in LF, CR LF or CR. [any] */
std::vector<CsvLine> csvLines (std::string_view text);

/** Without blanks and quotation marks at both ends. [any] */
std::string_view csvStripped (std::string_view);

/** How many characters mark a line as a comment: those of #, %, ! or //, else 0. [any] */
std::size_t csvCommentMark (std::string_view line);

/** What separates cells, as a line of numbers shows: ; tab , or a blank. A comma that digits follow is the decimal sign
    where blanks separate. [any] */
char csvSeparator (std::string_view line);

/** The stripped cells of a line; separators between quotation marks do not count. [any] */
std::vector<std::string_view> csvCells (std::string_view line, char separator);

/** The number of a cell, with a point or, where commas do not separate, a comma; NaN where it is empty or says so;
    nothing if it is something else. [any] */
std::optional<double> csvNumber (std::string_view cell, char separator);
} // namespace antinode
