#pragma once

#include "Tolerance.h"

#include <string>

namespace antinode
{
/** One of several designs that are compared on the same devices. */
struct DesignTolerance
{
    std::string name;       ///< "nominal" or "robust".
    double peakVoltage = 0; ///< V
    Tolerance tolerance;
};
} // namespace antinode
