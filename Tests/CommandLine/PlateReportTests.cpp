#include "Support/SinePlate.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_reports/FocusReport.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
RenderedFocus twoFocuses (const ModalModel& model)
{
    FocusDescription focus;
    focus.name = "two places";
    focus.targets = { { TargetShape::gaussian, 0.14, 0.09, 0.05, 0.01, 1 },
                      { TargetShape::gaussian, 0.05, 0.05, 0.06, 0.008, -1, TargetProfile::separable, 0.05 } };
    focus.focusTime = 0.02;
    focus.modes.count = 10;
    return renderFocus (model, designFocus (model, focus, {}), {});
}
} // namespace

TEST_CASE ("Two focuses of opposite sign are reached on a plate at the same instant", "[command line]")
{
    const auto focus = twoFocuses (test::SinePlate().model (30));
    CHECK (focus.truncatedScore.vScore > 0.999);
    REQUIRE (focus.probes.size() == 2);
    const auto at = [&] (Eigen::Index probe) { return focus.render.probeVelocities (probe, focus.render.focusSample); };
    CHECK (at (0) > 0.007);
    CHECK (at (1) < -0.005);
}

TEST_CASE ("The report of a focus on a plate has maps and cross sections, with or without a grid", "[command line]")
{
    for (const auto& model : { test::SinePlate().model (30), test::scatteredPlate (30, 150) })
    {
        const auto focus = twoFocuses (model);
        const auto page = focusReport (focus, evaluateOutcome (focus));
        const auto& figures = page.sections.front().figures;
        REQUIRE (figures.size() == 6);
        CHECK (std::holds_alternative<HeatMap> (figures[0].chart));
        CHECK (std::holds_alternative<ChartGrid> (figures[1].chart));
        CHECK (std::holds_alternative<LineChart> (figures[2].chart));
        CHECK (figures[2].caption.find ("y = 90 mm") != std::string::npos);
        CHECK (figures[3].caption.find ("x = 140 mm") != std::string::npos);
        CHECK (page.sections[2].figures[1].caption == "Velocity at the probe at x = 50 mm, y = 50 mm.");
        CHECK (renderReport (page).find ("Velocity reached at the focus") != std::string::npos);
    }
}
