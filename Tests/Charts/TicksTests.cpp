#include <antinode_reports/Ticks.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace antinode;

TEST_CASE ("A nice step is 1, 2 or 5 times a power of ten and gives no more parts than asked for")
{
    CHECK (niceStep (10, 10) == Approx (1));
    CHECK (niceStep (10, 9) == Approx (2));
    CHECK (niceStep (10, 4) == Approx (5));
    CHECK (niceStep (0.03, 3) == Approx (0.01));
    CHECK (niceStep (7e-9, 5) == Approx (2e-9));
}

TEST_CASE ("Ticks are the multiples of a nice step inside the range")
{
    CHECK (linearTicks ({ 0, 50 }, 5) == std::vector<double> { 0, 10, 20, 30, 40, 50 });
    CHECK (linearTicks ({ -66, 66 }, 4) == std::vector<double> { -50, 0, 50 });
    CHECK (linearTicks ({ 0.1, 0.9 }, 4).size() == 4);
}

TEST_CASE ("Any range gives a few finite ticks, even one that is empty, huge or not a number")
{
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    const std::vector<AxisRange> ranges {
        { 3, 3 },      { 5, -5 },          { 0, 0 },          { NAN, 1 },    { -infinity, infinity },
        { 0, 1e-300 }, { 1e15, 1e15 + 1 }, { -1e308, 1e308 }, { -1e-9, 1e9 }
    };
    for (const auto range : ranges)
        for (const auto maximumTicks : { 0, 1, 2, 7, 40 })
        {
            const auto ticks = linearTicks (range, maximumTicks);
            INFO (range.minimum << " to " << range.maximum << ", " << maximumTicks);
            CHECK (ticks.size() <= static_cast<std::size_t> (maximumTicks) + 4);
            CHECK (std::all_of (ticks.begin(), ticks.end(), [] (double tick) { return std::isfinite (tick); }));
        }
}

TEST_CASE ("Ticks of a logarithmic axis are powers of ten, thinned out evenly")
{
    const auto all = decadeTicks ({ 1e-3, 10 }, 10);
    REQUIRE (all.size() == 5);
    CHECK (all.front() == Approx (1e-3));
    CHECK (all.back() == Approx (10));
    const auto some = decadeTicks ({ 1e-12, 1 }, 5);
    REQUIRE (some.size() == 5);
    CHECK (some[1] / some[0] == Approx (1e3));
}

TEST_CASE ("A nice range encloses its data")
{
    const auto range = niceRange ({ -8.7, 41 }, 6);
    CHECK (range.minimum == Approx (-10));
    CHECK (range.maximum == Approx (50));
}

TEST_CASE ("Numbers are written with a true minus, thin spaces and powers of ten")
{
    CHECK (formatNumber (12.345) == "12.3");
    CHECK (formatNumber (-0.00123) == "\u22120.00123");
    CHECK (formatNumber (9.996) == "10.0");
    CHECK (formatNumber (1.234e-6) == "1.23×10⁻⁶");
    CHECK (formatNumber (-999960, 4) == "\u22121.000×10⁶");
    CHECK (formatNumber (5e-324) == "4.94×10⁻³²⁴");
    CHECK (formatNumber (0) == "0");
    CHECK (formatNumber (NAN) == "\u2013");
    CHECK (formatFixed (12345.6, 1) == "12\u202F345.6");
    CHECK (formatFixed (1234, 0) == "1234");
    CHECK (formatFixed (-0.0004, 2) == "0.00");
}

TEST_CASE ("Tick labels of one axis have the same decimals, as many as their step needs")
{
    CHECK (tickLabels ({ 0, 0.2, 0.4 }, 0) == std::vector<std::string> { "0.0", "0.2", "0.4" });
    CHECK (tickLabels ({ 0, 2e-4, 4e-4 }, -6) == std::vector<std::string> { "0", "200", "400" });
    CHECK (commonExponent ({ 0, 4e-4 }) == -6);
    CHECK (commonExponent ({ -3e6, 1 }) == 6);
    CHECK (commonExponent ({ 0, 31000 }) == 0);
}
