#include "Distribution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Coefficients = std::array<double, 8>;

double polynomial (const Coefficients& coefficients, double x)
{
    double value = 0;

    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
        value = value * x + *c;

    return value;
}

/** The share of the standard normal distribution below a number. */
double normalShare (double x)
{
    return 0.5 * std::erfc (-x / std::numbers::sqrt2);
}

/** Of what lies between two bounds; both in the lower half, or on both sides of the middle, where shares are exact. */
double betweenBounds (double lower, double upper, double share)
{
    const auto below = normalShare (lower), above = normalShare (upper);
    return std::clamp (normalQuantile (below + share * (above - below)), lower, upper);
}
} // namespace

double normalQuantile (double share)
{
    constexpr Coefficients middleAbove { 3.3871328727963666080e0,  1.3314166789178437745e+2, 1.9715909503065514427e+3,
                                         1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                                         3.3430575583588128105e+4, 2.5090809287301226727e+3 };
    constexpr Coefficients middleBelow { 1.0,
                                         4.2313330701600911252e+1,
                                         6.8718700749205790830e+2,
                                         5.3941960214247511077e+3,
                                         2.1213794301586595867e+4,
                                         3.9307895800092710610e+4,
                                         2.8729085735721942674e+4,
                                         5.2264952788528545610e+3 };
    constexpr Coefficients nearAbove { 1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                                       3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                                       2.27238449892691845833e-2, 7.74545014278341407640e-4 };
    constexpr Coefficients nearBelow { 1.0,
                                       2.05319162663775882187e0,
                                       1.67638483018380384940e0,
                                       6.89767334985100004550e-1,
                                       1.48103976427480074590e-1,
                                       1.51986665636164571966e-2,
                                       5.47593808499534494600e-4,
                                       1.05075007164441684324e-9 };
    constexpr Coefficients farAbove { 6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                                      2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                      2.71155556874348757815e-5, 2.01033439929228813265e-7 };
    constexpr Coefficients farBelow { 1.0,
                                      5.99832206555887937690e-1,
                                      1.36929880922735805310e-1,
                                      1.48753612908506148525e-2,
                                      7.86869131145613259100e-4,
                                      1.84631831751005468180e-5,
                                      1.42151175831644588870e-7,
                                      2.04426310338993978564e-15 };
    constexpr double middle = 0.425, middleSquared = 0.180625, near = 1.6, border = 5;
    const auto fromMiddle = share - 0.5;

    if (std::abs (fromMiddle) <= middle)
    {
        const auto r = middleSquared - fromMiddle * fromMiddle;
        return fromMiddle * polynomial (middleAbove, r) / polynomial (middleBelow, r);
    }

    const auto r = std::sqrt (-std::log (std::min (share, 1 - share)));
    const auto magnitude = r <= border ? polynomial (nearAbove, r - near) / polynomial (nearBelow, r - near)
                                       : polynomial (farAbove, r - border) / polynomial (farBelow, r - border);
    return fromMiddle < 0 ? -magnitude : magnitude;
}

double quantile (const Distribution& distribution, double share)
{
    const auto& [kind, minimum, maximum, mean, deviation] = distribution;

    if (kind == DistributionKind::uniform)
        return std::min (minimum + share * (maximum - minimum), maximum);

    if (! (deviation > 0))
        return std::clamp (mean, minimum, maximum);

    const auto lower = (minimum - mean) / deviation, upper = (maximum - mean) / deviation;
    const auto standard = lower > 0 ? -betweenBounds (-upper, -lower, 1 - share) : betweenBounds (lower, upper, share);
    return std::clamp (mean + deviation * standard, minimum, maximum);
}

std::array<std::uint32_t, 4> philox (std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key)
{
    constexpr int rounds = 10, halfWord = 32;
    constexpr std::uint64_t firstFactor = 0xD2511F53, secondFactor = 0xCD9E8D57;
    constexpr std::uint32_t firstWeyl = 0x9E3779B9, secondWeyl = 0xBB67AE85;

    for (int round = 0; round < rounds; ++round)
    {
        const auto first = firstFactor * counter[0], second = secondFactor * counter[2];
        counter = { static_cast<std::uint32_t> (second >> halfWord) ^ counter[1] ^ key[0],
                    static_cast<std::uint32_t> (second),
                    static_cast<std::uint32_t> (first >> halfWord) ^ counter[3] ^ key[1],
                    static_cast<std::uint32_t> (first) };
        key = { key[0] + firstWeyl, key[1] + secondWeyl };
    }

    return counter;
}

std::uint64_t randomBits (std::uint64_t seed, std::uint64_t index, std::uint32_t stream)
{
    constexpr int halfWord = 32;
    const auto low = [] (std::uint64_t word) { return static_cast<std::uint32_t> (word); };
    const auto high = [] (std::uint64_t word) { return static_cast<std::uint32_t> (word >> halfWord); };
    const auto words = philox ({ low (index), high (index), stream, 0 }, { low (seed), high (seed) });
    return (std::uint64_t { words[0] } << halfWord) | words[1];
}

double randomUniform (std::uint64_t seed, std::uint64_t index, std::uint32_t stream)
{
    constexpr int dropped = 12; // the middle of a step of 2^-52 is exact, and never 0 or 1
    return (static_cast<double> (randomBits (seed, index, stream) >> dropped) + 0.5) * 0x1p-52;
}
} // namespace antinode
