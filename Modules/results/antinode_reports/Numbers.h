#pragma once

#include "Ticks.h"

#include <string>
#include <vector>

namespace antinode
{
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
