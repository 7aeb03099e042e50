#include <antinode_sweep/SobolSequence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <set>
#include <vector>

using namespace antinode;

namespace
{
double coordinate (std::uint32_t index, int dimension)
{
    return sobolPoint (index, dimension) * 0x1p-32;
}

/** x times a polynomial of degree below s, modulo another of degree s. Bits are coefficients over GF(2). */
std::uint32_t timesX (std::uint32_t value, std::uint32_t polynomial, int degree)
{
    value <<= 1;
    return (value >> degree) & 1 ? value ^ polynomial : value;
}
} // namespace

TEST_CASE ("Sobol's sequence begins with the points that Joe and Kuo published", "[sweep]")
{
    // The output of `sobol 10 3 new-joe-kuo-6.21201` on https://web.maths.unsw.edu.au/~fkuo/sobol/.
    constexpr std::array<std::array<double, 3>, 10> published { { { 0, 0, 0 },
                                                                  { 0.5, 0.5, 0.5 },
                                                                  { 0.75, 0.25, 0.25 },
                                                                  { 0.25, 0.75, 0.75 },
                                                                  { 0.375, 0.375, 0.625 },
                                                                  { 0.875, 0.875, 0.125 },
                                                                  { 0.625, 0.125, 0.875 },
                                                                  { 0.125, 0.625, 0.375 },
                                                                  { 0.1875, 0.3125, 0.9375 },
                                                                  { 0.6875, 0.8125, 0.4375 } } };

    for (std::uint32_t i = 0; i < published.size(); ++i)
        for (int d = 0; d < 3; ++d)
            CHECK (coordinate (i, d) == published[i][static_cast<std::size_t> (d)]);
}

TEST_CASE ("Each polynomial of the table is primitive and no two are the same", "[sweep]")
{
    std::set<std::pair<int, std::uint32_t>> seen;

    for (int d = 1; d < sobolDimensions; ++d)
    {
        const auto [degree, coefficients, numbers] = sobolDirection (d);
        const auto polynomial = (1U << degree) | (coefficients << 1) | 1;
        CHECK (seen.insert ({ degree, coefficients }).second);

        // x has the order 2^s - 1 modulo a primitive polynomial.
        std::uint32_t power = 1;
        std::uint32_t order = 0;

        do
        {
            power = timesX (power, polynomial, degree);
            ++order;
        } while (power != 1 && order < (1U << degree));

        CHECK (order == (1U << degree) - 1);

        for (std::size_t i = 0; i < numbers.size(); ++i)
        {
            CHECK (numbers[i] % 2 == 1);
            CHECK (numbers[i] < (2U << i));
        }
    }
}

TEST_CASE ("The first 2^k points of every dimension lie one in each of 2^k equal intervals", "[sweep]")
{
    constexpr std::uint32_t count = 256;

    for (int d = 0; d < sobolDimensions; ++d)
    {
        std::bitset<count> taken;

        for (std::uint32_t i = 0; i < count; ++i)
            taken.set (static_cast<std::size_t> (coordinate (i, d) * count));

        CHECK (taken.all());
    }
}

TEST_CASE ("The first 2^s points of all dimensions together fill every orthant: property A of Joe and Kuo", "[sweep]")
{
    // The table was made so that the first 2^s points have one in each of the 2^s halves of the first s dimensions.
    constexpr int dimensions = 16;
    std::vector<bool> taken (1U << dimensions);

    for (std::uint32_t i = 0; i < taken.size(); ++i)
    {
        std::size_t orthant = 0;

        for (int d = 0; d < dimensions; ++d)
            orthant |= static_cast<std::size_t> (coordinate (i, d) >= 0.5) << d;

        taken[orthant] = true;
    }

    CHECK (std::count (taken.begin(), taken.end(), true) == static_cast<std::ptrdiff_t> (taken.size()));
}
