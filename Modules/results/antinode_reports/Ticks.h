#pragma once

#include <vector>

namespace antinode
{
/** The range of an axis, minimum below maximum. */
struct AxisRange
{
    double minimum = 0, maximum = 1;
};

/** A range that can be drawn, whatever came in: finite, ascending, and wide enough to be resolved in double
    precision. [any] */
AxisRange usableRange (AxisRange);

/** The smallest of 1, 2, 5 times a power of ten that divides the span into no more than this many parts.
    @param span  more than 0 [any] */
double niceStep (double span, int maximumParts);

/** All multiples of a nice step inside a range: at least 2 of them for most = 2 or more, and never more than most + 1.
    [any] */
std::vector<double> linearTicks (AxisRange, int maximumTicks);

/** Powers of ten inside a range of positive values, thinned out evenly to no more than most. [any] */
std::vector<double> decadeTicks (AxisRange, int maximumTicks);

/** The range widened to multiples of its nice step. [any] */
AxisRange niceRange (AxisRange, int maximumParts);
} // namespace antinode
