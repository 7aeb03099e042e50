#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Tradeoff.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

TEST_CASE ("An undamped mode that grows steadily is in motion for as long as its velocity says", "[tradeoff]")
{
    // One held oscillation at the frequency of a mode of hardly any damping: q' = t/2 cos b t. Over many cycles |q'| is
    // above half of its last crest for the part of each cycle with |cos| > 1/(2 u), u = t/t_f from 1/2 to 1: the
    // integral of (2/pi) acos (1/(2u)).
    auto model = test::sineBeam (1, 1);
    model.dampingRatios.setConstant (1e-6);
    const auto b = dampedFrequencies (model)[0];
    const auto cycles = 40;
    VoltageProgram program;
    program.focusTime = cycles * 2 * std::numbers::pi / b;
    program.oscillations = { { 0, 0, program.focusTime, 0, b, 0, 1 } };
    program.allocation = Eigen::MatrixXd::Ones (1, 1);
    double share = 0;

    for (int n = 0; n < 1000; ++n)
        share += 0.5 / 1000 * 2 / std::numbers::pi * std::acos (1 / (2 * (0.5 + 0.5 * (n + 0.5) / 1000)));

    CHECK (timeInMotion (model, program, { 0 }) == Approx (share * program.focusTime).epsilon (0.05));
}

TEST_CASE ("A trade-off: more growth takes more voltage for less motion, and nothing beats the bound", "[tradeoff]")
{
    const auto model = test::sineBeam (8, 4);
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 2;
    double last = 0;
    const auto tradeoff = sweepTradeoff (model, focus, { Reconstruction::bandLimited, 96000 },
                                         [&] (double share)
                                         {
                                             CHECK (share > last);
                                             last = share;
                                         });
    CHECK (last == 1);
    REQUIRE (tradeoff.lowerBoundVoltage > 0);
    bool hasFront = false;

    for (std::size_t i = 0; i < tradeoff.points.size(); ++i)
    {
        const auto& point = tradeoff.points[i];
        CHECK (point.failure.empty());
        CHECK (point.timeInMotion > 0);
        CHECK (point.timeInMotion < focus.focusTime);
        hasFront = hasFront || point.isOnFront;

        if (point.fieldError < 1e-3)
            CHECK (point.peakVoltage > 0.999 * tradeoff.lowerBoundVoltage);

        if (point.method == AllocationMethod::exact && point.envelopeFolds > 1)
        {
            CHECK (point.peakVoltage > tradeoff.points[i - 1].peakVoltage);
            CHECK (point.timeInMotion < tradeoff.points[i - 1].timeInMotion);
        }
    }

    CHECK (hasFront);
}
