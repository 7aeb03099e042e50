#pragma once

#include "ResponseUnit.h"

#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** The content of a column. */
enum class CsvColumnKind
{
    unknown,
    real,
    imaginary,
    magnitude,
    decibel,
    phase,
    coherence
};

/** The meaning of a column's heading. */
struct CsvHeading
{
    CsvColumnKind kind = CsvColumnKind::unknown;
    std::string point, reference;
    bool isDegrees = false, isRadians = false;
    std::optional<ResponseUnit> unit;
};

/** Reads "P3 C1 real", "H(point 3, driver 1) phase [deg]", "real_P3_C1 (m/s)/V" and the like. [any] */
CsvHeading csvHeading (std::string_view text);

/** The first unit of a response that a text names, else what its words say of the quantity. [any] */
std::optional<ResponseUnit> unitInText (std::string_view text);

/** Words in lower case: letters and digits without what is between them. [any] */
std::vector<std::string> splitWords (std::string_view text);
} // namespace antinode
