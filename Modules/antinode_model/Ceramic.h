#pragma once

#include <string>

namespace antinode
{
/** A ceramic (bimorph): its extent and limits. Ceramic k is output channel k. */
struct Ceramic
{
    std::string name;
    double xMinimum = 0, xMaximum = 0; ///< Extent, m.
    double yMinimum = 0, yMaximum = 0; ///< Extent, m; both 0 on a line.
    double voltageLimit = 0;           ///< U_max, V, at least 0.
    double slewLimit = 0;              ///< max |dU/dt|, V/s; 0: none.
};
} // namespace antinode
