#include "Support/SineBeam.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Tradeoff.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
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
    const auto tradeoff = sweepTradeoff (
        model, focus, { Reconstruction::bandLimited, 96000 },
        [&] (const Tradeoff& soFar)
        {
            CHECK (soFar.expectedShare > last);
            CHECK (soFar.planned == 22);
            last = soFar.expectedShare;
        },
        [] (const FocusDesign& design) { return peakVoltage (design); });
    CHECK (last == Approx (1));
    CHECK (tradeoff.points.size() == 22);
    REQUIRE (tradeoff.lowerBoundVoltage > 0);
    bool hasFront = false;

    for (std::size_t i = 0; i < tradeoff.points.size(); ++i)
    {
        const auto& point = tradeoff.points[i];
        CHECK (point.failure.empty());
        CHECK (point.feltContrast == point.peakVoltage); // What is asked of a design is told of its point.
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

TEST_CASE ("A trade-off that is cancelled has handed out its finished designs, the same as in the whole", "[tradeoff]")
{
    const auto model = test::sineBeam (8, 4);
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 2;
    const Playback playback { Reconstruction::bandLimited, 96000 };
    const auto whole = sweepTradeoff (model, focus, playback);
    std::atomic<bool> goesOn = true;
    Tradeoff kept;

    {
        const WatchScope scope ([&] { return goesOn.load(); });
        CHECK_THROWS_AS (sweepTradeoff (model, focus, playback,
                                        [&] (const Tradeoff& soFar)
                                        {
                                            kept = soFar;
                                            goesOn = soFar.points.size() < 3;
                                        }),
                         Cancelled);
    }

    REQUIRE (kept.points.size() >= 3);
    REQUIRE (kept.points.size() < kept.planned);

    for (const auto& point : kept.points)
        CHECK (std::any_of (whole.points.begin(), whole.points.end(),
                            [&] (const TradeoffPoint& other)
                            {
                                return other.method == point.method && other.envelopeFolds == point.envelopeFolds
                                       && other.limitMultiple == point.limitMultiple
                                       && other.peakVoltage == point.peakVoltage
                                       && other.fieldError == point.fieldError;
                            }));
}
