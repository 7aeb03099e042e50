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
    frequency,
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
    std::string unknownUnit; ///< What stands where a unit does, and is none that is known.
};

/** Reads "P3 C1 real", "H(point 3, driver 1) phase [deg]", "real_P3_C1 (m/s)/V" and the like. [any] */
CsvHeading csvHeading (std::string_view text);

/** The first unit of a response that a text names, else what its words say of the quantity. Numbers count behind "re":
   "dB re 1e-6 m/s". [any] */
std::optional<ResponseUnit> unitInText (std::string_view text);

/** What stands in brackets as units do, "furlong/N", or alone behind the word "unit"; empty if there is no such text,
   or if it is known. [any] */
std::string unknownUnitInText (std::string_view text);

/** Words in lower case: letters and digits without what is between them. [any] */
std::vector<std::string> splitWords (std::string_view text);
} // namespace antinode
