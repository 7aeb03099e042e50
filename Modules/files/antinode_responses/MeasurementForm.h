#pragma once

#include "CsvHeading.h"

#include <string>
#include <string_view>

namespace antinode
{
/** The kind of a file of measured data. */
enum class MeasurementForm
{
    wave,
    matlab,
    universal,
    text
};

/** What its bytes say, not its name. [any] */
MeasurementForm measurementForm (std::string_view bytes);

/** Point and reference from a file's name, where it has words for them: "point3_driver2.csv", "P3-C1.wav". [any] */
CsvHeading rolesInFileName (const std::string& source);
} // namespace antinode
