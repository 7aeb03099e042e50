#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_reports/ModesReport.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("The gallery shows the lowest modes of a plate as maps, each scaled to 1")
{
    const auto grid = modeGallery (test::SinePlate().model (20), 8);
    REQUIRE (grid.panels.size() == 8);
    // 340 Hz: pi / 2 (1 / a^2 + 1 / b^2) sqrt (D / mu).
    CHECK (std::get<HeatMap> (grid.panels[0]).title == "1: 340 Hz");

    for (const auto& panel : grid.panels)
    {
        const auto& map = std::get<HeatMap> (panel);
        CHECK (map.isBare);
        CHECK (map.valueRange->minimum == -1);
        CHECK (map.valueRange->maximum == 1);
        CHECK (map.values.cwiseAbs().maxCoeff() == 1);
        CHECK (map.contours.nodalLinesFrom.has_value());
    }

    CHECK (modeGallery (test::SinePlate().model (5), 8).panels.size() == 5);
}

TEST_CASE ("The gallery shows the modes of a line as curves over its ceramics")
{
    const auto model = test::sineBeam (6, 3);
    const auto grid = modeGallery (model, 48);
    REQUIRE (grid.panels.size() == 6);
    const auto& chart = std::get<LineChart> (grid.panels[5]);
    CHECK (chart.title.substr (0, 3) == "6: ");
    CHECK (chart.spans.size() == 3);
    CHECK (chart.series[0].y.cwiseAbs().maxCoeff() == 1);
    CHECK (chart.xRange->minimum == Approx (-100));
}

TEST_CASE ("Participation is relative to the strongest ceramic of each mode, what nothing drives is 0")
{
    auto model = test::SinePlate().model (10);
    model.participation.row (3).setZero();
    const auto chart = participationChart (model);
    REQUIRE (chart.values.rows() == 12);
    REQUIRE (chart.values.cols() == 10);
    CHECK (chart.columnNames.back() == "10");
    CHECK (chart.rowNames.front() == "C1");

    for (Eigen::Index mode = 0; mode < 10; ++mode)
    {
        CHECK (chart.values.col (mode).cwiseAbs().maxCoeff() == (mode == 3 ? 0 : 1));
        CHECK ((chart.values.col (mode).array() * model.participation.row (mode).transpose().array()).minCoeff() >= 0);
    }
}

TEST_CASE ("A device is seen from above: a plate to scale, a line as a strip")
{
    const auto plate = deviceChart (test::SinePlate().model (3));
    CHECK (plate.yLabel == "y (mm)");
    CHECK (plate.y.maximum == Approx (150));
    CHECK (plate.rectangles.size() == 12);
    const auto beam = deviceChart (test::sineBeam (3, 4));
    CHECK (beam.yLabel.empty());
    REQUIRE (beam.rectangles.size() == 4);
    CHECK (beam.rectangles[0].yMaximum > beam.rectangles[0].yMinimum);
}
