#pragma once

#include <string>
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

/** A number with the given number of decimals, a true minus sign, thin spaces between thousands from 10 000 on, and no
   negative zero. The same in every locale. A value that is not finite gives a dash. [any] */
std::string formatFixed (double value, int decimals);

/** A number with the given number of significant digits: 12.3, 0.00123, 1.23×10⁻⁶ (outside 0.001 to 99 999). [any] */
std::string formatNumber (double value, int significantDigits = 3);

/** The power of ten, a multiple of three, that the labels of an axis leave out so that they stay short: 0 where they
   are short anyway. [any] */
int commonExponent (AxisRange);

/** An exponent as raised digits: ⁻⁶. [any] */
std::string superscript (int exponent);

/** "×10⁻⁶", or nothing for an exponent of 0. [any] */
std::string powerOfTen (int exponent);

/** Labels of evenly spaced ticks: all with the same decimals, as many as the step needs. [any] */
std::vector<std::string> tickLabels (const std::vector<double>& ticks, int exponent);
} // namespace antinode
