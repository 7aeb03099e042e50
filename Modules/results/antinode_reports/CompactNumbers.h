#pragma once

#include <Eigen/Core>

#include <string>

namespace antinode
{
/** Numbers as base64 of 8-byte or 4-byte floating point, little-endian, for scripts of pages. [any] */
std::string compactDoubles (const Eigen::VectorXd&);
std::string compactFloats (const Eigen::VectorXd&);

/** Small whole numbers as base64 of one byte each. Values: 0 to 255. [any] */
std::string compactBytes (const Eigen::VectorXi&);

/** Complex numbers as base64 of two bytes each: a level in half decibels, 254 for the largest, 0 for 0 and what lies
   more than 126 dB below it, 255 where a number is not finite; and an angle in 256 parts of a turn. Exact to 0.25 dB
   and 0.7 degrees.
    @param largest  the largest absolute value [any] */
std::string compactComplex (const Eigen::VectorXcd&, double largest);
} // namespace antinode
