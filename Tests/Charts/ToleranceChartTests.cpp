#include <antinode_reports/ToleranceReport.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
/** Field errors of 1 %, 2 %, ..., 100 %. */
DesignTolerance evenErrors()
{
    DesignTolerance design { "nominal", 10, {} };
    std::vector<double> errors;

    for (int i = 1; i <= 100; ++i)
    {
        errors.push_back (i / 100.0);
        design.tolerance.draws.push_back ({ { 1, errors.back() }, 1 });
    }

    design.tolerance.fieldError = computePercentiles (errors);
    design.tolerance.causes = { { 4, ToleranceKind::damping, 0.3 },
                                { 2, ToleranceKind::frequency, 0.2 },
                                { 4, ToleranceKind::frequency, 0.1 },
                                { {}, ToleranceKind::drift, 0.05 },
                                { 7, ToleranceKind::participation, 0.01 } };
    return design;
}
} // namespace

TEST_CASE ("The histogram counts every device once", "[views]")
{
    const auto chart = toleranceHistogram ({ evenErrors() });
    const auto& series = chart.series.at (0);
    double devices = 0;

    // Each bin stands twice, at its left and its right edge.
    for (Eigen::Index i = 1; i + 1 < series.y.size(); i += 2)
    {
        CHECK (series.y[i] == series.y[i + 1]);
        devices += series.y[i];
    }

    CHECK (devices == 100);
    CHECK (series.x[series.x.size() - 1] == Approx (100));
}

TEST_CASE ("The percentiles lie on the curve of shares", "[views]")
{
    const auto chart = toleranceShares ({ evenErrors() });
    REQUIRE (chart.series.size() == 2);
    const auto& curve = chart.series[0];
    const auto& dots = chart.series[1];
    CHECK (curve.y[99] == Approx (100));

    for (Eigen::Index i = 0; i < dots.x.size(); i += 2)
    {
        const auto* const after = std::lower_bound (curve.x.data(), curve.x.data() + curve.x.size(), dots.x[i]);
        CHECK (curve.y[after - curve.x.data()] == Approx (dots.y[i]).margin (1.01)); // a device is 1 %
    }
}

TEST_CASE ("The chart of causes shows each mode once, the worst first, and no drift", "[views]")
{
    const auto chart = toleranceCauseChart (evenErrors().tolerance, 2);
    CHECK (chart.categories == std::vector<std::string> { "5", "3" });
    REQUIRE (chart.series.size() == 3);
    CHECK (chart.series[0].values == Eigen::Vector2d (10, 20));
    CHECK (chart.series[1].values == Eigen::Vector2d (30, 0));
}
