#pragma once

#include <cstdint>
#include <span>

namespace antinode
{
/** How many dimensions the sequence has. */
inline constexpr int sobolDimensions = 32;

/** What a dimension is made from: a primitive polynomial x^s + a_1 x^(s-1) + ... + a_(s-1) x + 1, and the first numbers
   m_1 to m_s. */
struct SobolDirection
{
    int degree = 0;                              ///< s; 0 of the first dimension, which needs none.
    std::uint32_t coefficients = 0;              ///< a_1 ... a_(s-1) as bits, a_1 the highest.
    std::span<const std::uint32_t> firstNumbers; ///< m, s of them.
};

/** The table of a dimension, from 0. [any] S. Joe and F. Y. Kuo, new-joe-kuo-6.21201. */
SobolDirection sobolDirection (int dimension);

/** A coordinate of a point of Sobol's sequence in parts of 2^32, in the order of Gray's code, the first point 0. Needs
   no other points.
    @param index      of the point, any
    @param dimension  0 to sobolDimensions - 1
    [any] S. Joe and F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci.
   Comput. 30, 2635 (2008). */
std::uint32_t sobolPoint (std::uint32_t index, int dimension);
} // namespace antinode
