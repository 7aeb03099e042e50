#pragma once

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
} // namespace antinode
