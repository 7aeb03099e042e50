#pragma once

#include <cstddef>
#include <initializer_list>
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
} // namespace antinode
