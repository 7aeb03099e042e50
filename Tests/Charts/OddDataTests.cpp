#include "ExampleCharts.h"

#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace antinode;
using namespace antinode::example_charts;

namespace
{
constexpr auto notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr auto infinity = std::numeric_limits<double>::infinity();
} // namespace

TEST_CASE ("A single sample of 20 000 shows in the picture")
{
    auto chart = traces();
    chart.values = Eigen::MatrixXd::Zero (2, 20000);
    const auto flat = decoded (toPng (chart));
    chart.values (1, 13131) = 49;
    chart.values (0, 13131) = 1e-9;
    const auto spiked = decoded (toPng (chart));
    auto differing = 0;
    // Inside the plot only: the peak at its right has changed as well.
    for (int y = 0; y < flat.getHeight(); ++y)
        for (int x = 100; x < 350; ++x)
            differing += flat.getPixelAt (x, y) != spiked.getPixelAt (x, y) ? 1 : 0;
    CHECK (differing > 20);
}

TEST_CASE ("Empty charts of every kind say that there is no data")
{
    for (const auto& chart :
         std::vector<Chart> { LineChart {}, BarChart {}, HeatMap {}, StackedTraces {}, PlanView {}, ChartGrid {} })
        CHECK (pixelsUnlike (decoded (toPng (chart)), Theme::light().background) > 50);
    LineChart nothing;
    nothing.series = { { "nothing", Eigen::VectorXd::Constant (5, notANumber),
                         Eigen::VectorXd::Constant (5, notANumber) } };
    LineChart empty;
    empty.series = { { "nothing", {}, {} } };
    CHECK (toPng (nothing) == toPng (empty));
}

TEST_CASE ("Values that are not finite, huge or tiny are drawn as gaps or bounded, never a crash")
{
    std::mt19937 random (7);
    const std::vector<double> odd { notANumber, infinity, -infinity, 1e308, -1e308, 5e-324, 0, 1, -40 };
    std::uniform_int_distribution<std::size_t> pick (0, odd.size() - 1);
    const auto any = [&] { return odd[pick (random)]; };
    for (int round = 0; round < 40; ++round)
    {
        auto line = lines();
        line.series[0].y = Eigen::VectorXd::NullaryExpr (400, any);
        line.series[1].x = Eigen::VectorXd::NullaryExpr (400, any);
        line.series[1].points = true;
        line.logarithmicX = round % 2 == 0;
        line.logarithmicY = round % 3 == 0;
        line.limits = { { any(), "a" }, { any(), "b" } };
        line.markers = { { any(), "c" }, { any(), "d" } };
        line.spans = { { any(), any(), "e" } };
        if (round % 4 == 0)
            line.xRange = line.yRange = AxisRange { any(), any() };
        auto bar = bars();
        bar.series[0].values = Eigen::VectorXd::NullaryExpr (3, any);
        bar.logarithmic = round % 2 == 0;
        auto heat = map();
        heat.values = Eigen::MatrixXd::NullaryExpr (12, 20, any);
        heat.x = { any(), any() };
        heat.points = { { any(), any(), "f" } };
        heat.rectangles = { { any(), any(), any(), any(), "g" } };
        heat.contours = { { any() }, any() };
        auto seen = plan();
        seen.y = { any(), any() };
        seen.points = heat.points;
        seen.rectangles = heat.rectangles;
        auto stack = traces();
        stack.values = Eigen::MatrixXd::NullaryExpr (2, 2500, any);
        stack.limits = Eigen::Vector2d (any(), any());
        stack.step = any();
        for (const auto& chart : std::vector<Chart> { line, bar, heat, seen, stack })
            CHECK (decoded (renderPng (chart, 160, 100, 1, Theme::dark())).isValid());
    }
}

TEST_CASE ("Charts too small for their labels and names in any script are drawn")
{
    auto stack = traces();
    stack.names = { std::string ("\xff\xfe broken \xe2\x82"),
                    "\u6771\u4EAC \u0645\u0631\u062D\u0628\u0627 \U0001F600" };
    for (const auto& chart : std::vector<Chart> { lines(), bars(), map(), table(), bareMap(), plan(), stack, grid() })
        CHECK (decoded (renderPng (chart, 16, 16, 1, Theme::light())).getWidth() == 16);
    CHECK (decoded (toPng (stack)).isValid());
}

TEST_CASE ("Parts of a chart that do not belong together, and impossible sizes, are bad input")
{
    auto line = lines();
    line.series[0].y.conservativeResize (3);
    CHECK_THROWS_AS (toPng (line), InputError);
    auto cells = table();
    cells.rowNames.pop_back();
    CHECK_THROWS_AS (toPng (cells), InputError);
    auto bar = bars();
    bar.categories.pop_back();
    CHECK_THROWS_AS (toPng (bar), InputError);
    auto stack = traces();
    stack.names.pop_back();
    CHECK_THROWS_AS (toPng (stack), InputError);
    CHECK_THROWS_AS (renderPng (lines(), 0, 100, 1, Theme::light()), InputError);
    CHECK_THROWS_AS (renderPng (lines(), 100, 9000, 1, Theme::light()), InputError);
    CHECK_THROWS_AS (renderPng (lines(), 100, 100, std::nanf (""), Theme::light()), InputError);
}
