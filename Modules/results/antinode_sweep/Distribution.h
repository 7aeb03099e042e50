#pragma once

#include <array>
#include <cstdint>

namespace antinode
{
enum class DistributionKind
{
    uniform,
    normal
};

/** How a number is distributed, all of it between two bounds: a normal one is cut off there and has its area made 1
   again. */
struct Distribution
{
    DistributionKind kind = DistributionKind::uniform;
    double minimum = 0, maximum = 1; ///< Infinite where a normal one is not cut off.
    double mean = 0, deviation = 1;  ///< Of a normal one, before it is cut off.
};

/** The number below which a share of a distribution lies. @param share  above 0 and below 1 [any] */
double quantile (const Distribution&, double share);

/** The same of the normal distribution with mean 0 and deviation 1, to 1e-15 of it.
    [any] M. J. Wichura, algorithm AS 241, Applied Statistics 37, 477 (1988). */
double normalQuantile (double share);

/** Four random words of a counter: Philox 4x32 with 10 rounds. The same on every computer; no state, so the words of
   any counter need no others. [any] Salmon et al., Parallel random numbers: as easy as 1, 2, 3, SC 2011. */
std::array<std::uint32_t, 4> philox (std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/** 64 random bits that depend on these numbers only.
    @param index   for example the number of a case
    @param stream  for example which of its numbers it is
    [any] */
std::uint64_t randomBits (std::uint64_t seed, std::uint64_t index, std::uint32_t stream);

/** A number above 0 and below 1, evenly distributed, in steps of 2^-52. [any] */
double randomUniform (std::uint64_t seed, std::uint64_t index, std::uint32_t stream);
} // namespace antinode
