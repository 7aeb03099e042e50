#include <antinode_sweep/Distribution.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("Philox gives the words that its authors published", "[sweep]")
{
    // Random123 1.14, tests/kat_vectors: philox 4x32 10.
    using Words = std::array<std::uint32_t, 4>;
    constexpr auto ones = 0xFFFFFFFF;
    CHECK (philox ({ 0, 0, 0, 0 }, { 0, 0 }) == Words { 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8 });
    CHECK (philox ({ ones, ones, ones, ones }, { ones, ones })
           == Words { 0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd });
    CHECK (philox ({ 0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344 }, { 0xa4093822, 0x299f31d0 })
           == Words { 0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1 });
}

TEST_CASE ("Random shares are even, and neighbours have nothing in common", "[sweep]")
{
    constexpr int count = 100'000;
    double sum = 0, squares = 0, products = 0, before = 0;

    for (int i = 0; i < count; ++i)
    {
        const auto share = randomUniform (7, static_cast<std::uint64_t> (i), 3) - 0.5;
        sum += share;
        squares += share * share;
        products += share * before;
        before = share;
    }

    // Mean 0 +- 1/sqrt (12 N), variance 1/12 +- 1/sqrt (180 N), products 0 +- 1/(12 sqrt (N)): five deviations.
    const auto root = std::sqrt (static_cast<double> (count));
    CHECK (std::abs (sum / count) < 5 / std::sqrt (12.0) / root);
    CHECK (std::abs (squares / count - 1.0 / 12) < 5 / std::sqrt (180.0) / root);
    CHECK (std::abs (products / count) < 5.0 / 12 / root);
}
