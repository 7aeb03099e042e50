#pragma once

#include <vector>

namespace antinode
{
/** The median, of an even number of values the upper of the two in the middle.
    @param values  at least one, all finite
    [worker] */
double median (std::vector<double> values);
} // namespace antinode
