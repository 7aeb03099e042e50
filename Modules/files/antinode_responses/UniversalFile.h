#pragma once

#include "UniversalSets.h"

#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** The data sets of a universal file: 58 and 58b, 55, 15, 2411, 82, 151, 164, 2412 and 2414 as what they mean, others
   as they stand.

    Sets are read as instruments and programs write them, which is not always as the format says: counts that are wrong
   (what is there counts), numbers without blanks between them, exponents with D or without letter, half-full lines,
   units longer than their field, Latin-1 text (it becomes UTF-8).
    @param bytes   the whole file
    @param source  how errors name it
    @throws InputError  source, line, what is wrong
    [worker] Docs/FileFormats.md; SDRC universal data sets, https://www.ceas3.uc.edu/sdrluff. */
std::vector<UniversalSet> readUniversalFile (std::string_view bytes, const std::string& source);

/** Data sets as a universal file, in the columns of the format: six significant digits in single precision, 13 in
   double; binary functions as they are. What was read and written once is the same to the byte whenever it is read and
   written again. No dates are written: the same sets give the same bytes.
    @throws InputError  when a number is not finite
    [worker] */
std::string encodeUniversalFile (const std::vector<UniversalSet>&);
} // namespace antinode
