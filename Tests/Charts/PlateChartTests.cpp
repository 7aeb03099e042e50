#include "Support/SinePlate.h"

#include <antinode_focus/Projection.h>
#include <antinode_focus/TargetField.h>
#include <antinode_reports/FocusCharts.h>
#include <antinode_reports/PlateCharts.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
const std::vector<Target> twoTargets { { TargetShape::gaussian, 0.13, 0.08, 0.04, 0.04, 1 },
                                       { TargetShape::gaussian, 0.05, 0.04, 0.03, 0.02, -1 } };

FocusDesign designOn (const ModalModel& model)
{
    FocusDesign design;
    design.description.targets = twoTargets;
    design.target = projectField (model, targetField (model.surface, twoTargets, {}));
    const auto selection = selectModes (model, design.target, { 30, ModeOrder::energy, {}, {}, {} });
    design.controlledModes = selection.modes;
    design.truncatedField = selection.truncated;
    return design;
}
} // namespace

TEST_CASE ("A plate's field is a map in mm and mm/s with ceramics, focuses and half of its peak")
{
    const auto model = test::SinePlate().model (40);
    const auto chart = plateFieldChart (model, targetField (model.surface, twoTargets, {}), "wanted", twoTargets);
    CHECK (chart.valueLabel == "wanted (mm/s)");
    CHECK (chart.equalAspect);
    CHECK (chart.x.maximum == Approx (200));
    CHECK (chart.y.maximum == Approx (150));
    REQUIRE (chart.values.cols() == 220);
    REQUIRE (chart.values.rows() == 165);
    Eigen::Index row = 0, column = 0;
    CHECK (chart.values.maxCoeff (&row, &column) == Approx (40).epsilon (0.002));
    CHECK (column == 143);                 // x = 130 mm
    CHECK (row == Approx (88).margin (1)); // y = 80 mm
    REQUIRE (chart.rectangles.size() == 12);
    CHECK (chart.rectangles[4].label == "C5");
    CHECK (chart.rectangles[4].xMinimum == Approx (1000 * model.ceramics[4].xMinimum));
    CHECK (chart.rectangles[4].yMaximum == Approx (1000 * model.ceramics[4].yMaximum));
    REQUIRE (chart.points.size() == 2);
    CHECK (chart.points[1].x == Approx (50));
    CHECK (chart.points[1].y == Approx (40));
    REQUIRE (chart.contours.levels.size() == 2);
    CHECK (chart.contours.levels[0] == 0.5 * chart.values.maxCoeff());
    CHECK (chart.contours.levels[1] == -chart.contours.levels[0]);
}

TEST_CASE ("Wanted, carried and reached have one scale, their difference its own")
{
    const auto model = test::SinePlate().model (40);
    const auto design = designOn (model);
    const Eigen::VectorXd reached = 0.9 * design.truncatedField;
    const auto grid = plateFieldsChart (model, design, reached);
    REQUIRE (grid.panels.size() == 4);
    const auto panel = [&] (std::size_t k) -> const HeatMap& { return std::get<HeatMap> (grid.panels[k]); };
    REQUIRE (panel (0).valueRange.has_value());
    CHECK (panel (0).valueRange->maximum == panel (1).valueRange->maximum);
    CHECK (panel (1).valueRange->minimum == panel (2).valueRange->minimum);
    CHECK_FALSE (panel (3).valueRange.has_value());
    CHECK ((panel (2).values - 0.9 * panel (1).values).cwiseAbs().maxCoeff() < 1e-10);
    CHECK ((panel (3).values - panel (2).values + panel (0).values).cwiseAbs().maxCoeff() < 1e-10);
}

TEST_CASE ("Cross sections pass through the first focus and name the ceramics that they cross")
{
    const auto model = test::SinePlate().model (40);
    const auto design = designOn (model);

    for (const auto direction : { PlateDirection::alongX, PlateDirection::alongY })
    {
        const auto isAlongX = direction == PlateDirection::alongX;
        const auto chart = crossSectionChart (model, design, design.truncatedField, direction);
        REQUIRE (chart.series.size() == 3);
        const auto& wanted = chart.series[0];
        Eigen::Index peak = 0;
        CHECK (wanted.y.maxCoeff (&peak) == Approx (40).epsilon (1e-3));
        CHECK (wanted.x[peak] == Approx (isAlongX ? 130 : 80).margin (0.5));
        CHECK (wanted.x[400] == Approx (isAlongX ? 200 : 150));
        CHECK ((chart.series[1].y - chart.series[2].y).norm() == 0); // reached and carried
        std::vector<std::string> names;

        for (const auto& span : chart.spans)
            names.push_back (span.label);

        // Ceramics are 22 mm by 18 mm: the section crosses those whose centre is no farther than half of that.
        std::vector<std::string> crossed;

        for (const auto& c : model.ceramics)
            if (isAlongX ? std::abs (c.yMinimum + c.yMaximum - 0.16) <= 0.018
                         : std::abs (c.xMinimum + c.xMaximum - 0.26) <= 0.022)
                crossed.push_back (c.name);

        CHECK_FALSE (crossed.empty());
        CHECK (names == crossed);
    }
}

TEST_CASE ("The field over time follows the line through the focus of a plate")
{
    const auto model = test::SinePlate().model (40);
    const auto design = designOn (model);
    Render render;
    render.sampleRate = 100000;
    render.focusSample = 500;
    render.modalVelocities = Eigen::MatrixXd::Zero (40, 1001);
    render.modalVelocities (7, 500) = 0.01;
    const auto map = fieldOverTimeChart (model, design, render, 0.001);
    CHECK (map.xLabel == "x (mm)");
    REQUIRE (map.points.size() == 1);
    CHECK (map.points[0].x == Approx (130));
    const auto shape = shapesAt (model, 60.5 / 240 * 0.2, 0.08)[7];
    CHECK (map.values.col (60).cwiseAbs().maxCoeff() == Approx (std::abs (shape) * 0.01 * 1000).epsilon (1e-6));
}

TEST_CASE ("A figure's height follows the plate's aspect")
{
    auto surface = test::SinePlate().surface();
    const auto wide = plateFigureHeight (surface, 900, 1, 1);
    CHECK (wide > 560);
    CHECK (wide < 720);
    surface.yMaximum = 0.01;
    CHECK (plateFigureHeight (surface, 900, 1, 1) == 240);
    surface.yMaximum = 2;
    CHECK (plateFigureHeight (surface, 900, 1, 1) == 1400);
}
