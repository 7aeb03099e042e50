#include <antinode_sweep/Distribution.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace antinode;

namespace
{
constexpr auto infinity = std::numeric_limits<double>::infinity();

double normalShare (double x)
{
    return 0.5 * std::erfc (-x / std::sqrt (2));
}
} // namespace

TEST_CASE ("The quantile of the normal distribution is the inverse of the error function", "[sweep]")
{
    for (const auto share : { 1e-300, 1e-20, 1e-9, 0.001, 0.02, 0.0749, 0.0751, 0.3, 0.5 })
        CHECK (normalShare (normalQuantile (share)) == Approx (share).epsilon (1e-12));

    CHECK (normalQuantile (0.975) == Approx (1.959963984540054).epsilon (1e-15)); // of every table
    CHECK (normalQuantile (0.2) == Approx (-normalQuantile (0.8)).epsilon (1e-15));
}

TEST_CASE ("A normal distribution that is cut off has the shares of what is left", "[sweep]")
{
    for (const auto& [lower, upper] : { std::pair { -1.0, 2.0 }, { 5.0, 6.0 }, { -9.0, -8.0 }, { 0.5, infinity } })
        for (const auto share : { 0.01, 0.25, 0.5, 0.99 })
        {
            const Distribution distribution { DistributionKind::normal, 3 + 2 * lower, 3 + 2 * upper, 3, 2 };
            const auto value = (quantile (distribution, share) - 3) / 2;
            // By the tail that is farther from 1/2, where shares have all their digits.
            const auto sign = lower > 0 ? -1 : 1;
            const auto whole = normalShare (sign * upper) - normalShare (sign * lower);
            CHECK ((normalShare (sign * value) - normalShare (sign * lower)) / whole == Approx (share).epsilon (1e-9));
        }
}

TEST_CASE ("Distributions stay within their bounds at the ends", "[sweep]")
{
    for (const auto share : { 0x1p-53, 1 - 0x1p-53 })
    {
        const auto uniform = quantile ({ DistributionKind::uniform, -0.3, 0.7 }, share);
        CHECK ((uniform >= -0.3 && uniform <= 0.7));
        const auto normal = quantile ({ DistributionKind::normal, -1, 1, 0, 10 }, share);
        CHECK ((normal >= -1 && normal <= 1));
        CHECK (quantile ({ DistributionKind::normal, -infinity, infinity, 4, 0 }, share) == 4);
    }
}
