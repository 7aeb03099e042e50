#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A table of numbers from text. N rows, M columns. */
struct CsvTable
{
    std::vector<std::string>
        comments; ///< Lines before and after the numbers that are no headings, without their marks.
    std::vector<std::string>
        headings;            ///< M, or empty: of several lines of headings one below the other, with a blank between.
    Eigen::MatrixXd numbers; ///< N x M: NaN where a cell is empty or not finite.
};

/** Reads text in columns between commas, semicolons, tabs or blanks; numbers with a point or, where commas do not
   separate, a comma. A column of complex numbers becomes two, whose headings end in "real" and "imag". Lines that begin
   with #, %, ! or // are comments, as are those before the numbers that have another number of cells, and words behind
   the last number. Separators at the ends of lines, and a column of dates before one of times, do not count. Of a
   header of LabVIEW the units stand in the headings.
    @param source  how errors name the file
    @throws InputError  source, line, what is wrong: no numbers, rows of different lengths, a cell that is no number
    [worker] */
CsvTable readCsvTable (std::string_view text, const std::string& source);
} // namespace antinode
