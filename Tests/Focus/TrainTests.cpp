#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
FocusDescription train (std::vector<double> times, double limit = 150)
{
    FocusDescription focus;
    focus.focusTime = 0.025;
    focus.modes.count = 6;
    focus.allocation.voltageLimit = limit;

    for (std::size_t i = 0; i < times.size(); ++i)
    {
        focus.targets.push_back ({ TargetShape::sinc, i % 2 == 0 ? 0.02 : -0.03, 0, 0.025, 0.04, 1 });
        focus.targets.back().time = times[i];
    }

    return focus;
}

double fieldError (const ModalModel& model, const FocusDesign& design, std::size_t focus)
{
    const auto& moment = design.moments[focus];
    const auto states = predictStates (model, design.program, moment.time);
    return scoreField (model.surface, model.shapes * modalVelocities (model, states), moment.truncatedField).fieldError;
}
} // namespace

TEST_CASE ("Every focus of a train has the exact velocities of its own time", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = designFocus (model, train ({ 0.025, 0.031, 0.05 }), {});
    REQUIRE (design.moments.size() == 3);
    CHECK (design.program.focusTime == 0.025);
    CHECK (design.truncatedField == design.moments[0].truncatedField);

    for (const auto& moment : design.moments)
    {
        const auto reached = modalVelocities (model, predictStates (model, design.program, moment.time));
        const auto largest = moment.wanted.cwiseAbs().maxCoeff();

        for (std::size_t i = 0; i < design.controlledModes.size(); ++i)
            CHECK (reached[design.controlledModes[i]]
                   == Approx (moment.wanted[static_cast<Eigen::Index> (i)]).margin (1e-9 * largest));
    }

    for (std::size_t focus = 0; focus < 3; ++focus)
        CHECK (fieldError (model, design, focus) < 0.01);
}

TEST_CASE ("Targets at one time are one field, at whatever place of the list", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = train ({ 0.04, 0.025, 0.04 });
    focus.targets[1].time = {};
    const auto design = designFocus (model, focus, {});
    REQUIRE (design.moments.size() == 2);
    CHECK (design.moments[0].targets.size() == 1);
    CHECK (design.moments[1].targets.size() == 2);
    CHECK (design.moments[1].time == 0.04);

    auto single = train ({ 0.025, 0.025 });
    auto plain = single;
    plain.targets[0].time = plain.targets[1].time = {};
    CHECK (designFocus (model, single, {}).program.allocation == designFocus (model, plain, {}).program.allocation);
}

TEST_CASE ("The plate model reaches every focus of a train, band-limited and held", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
    {
        const Playback playback { reconstruction, 96000 };
        const auto design = designFocus (model, train ({ 0.025, 0.0330077 }), playback);
        RenderSettings settings;
        settings.playback = playback;
        settings.duration = 0.05;
        settings.probeShapes.resize (0, model.modes());
        const auto render = renderOffline (model, design.program, settings);

        for (const auto& moment : design.moments)
        {
            const auto position = (moment.time - design.program.focusTime) * playback.sampleRate;
            const auto sample = render.focusSample + std::llround (position);
            CHECK (std::abs (position - std::round (position)) < 1e-6);
            const auto score =
                scoreField (model.surface, model.shapes * render.modalVelocities.col (sample), moment.truncatedField);
            CHECK (score.vScore > 0.999);
            CHECK (score.fieldError < 0.01);
        }

        CHECK (std::any_of (design.choices.begin(), design.choices.end(),
                            [] (const std::string& choice) {
                                return choice == "The focus at 33.01 ms is moved to the nearest sample, at 33.01 ms.";
                            }));
    }
}

TEST_CASE ("A train has its brake after its last focus", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8, 200);
    auto focus = train ({ 0.025, 0.035 });
    focus.transients.brakeDuration = 0.015;
    const auto design = designFocus (model, focus, {});
    const auto states = predictStates (model, design.program, 0.05);
    CHECK (states.norm() < 1e-3 * predictStates (model, design.program, 0.036).norm());
    CHECK (fieldError (model, design, 1) < 0.01);
}

TEST_CASE ("Foci too close for the limit are refused with what would do", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8);
    const auto alone = designFocus (model, train ({ 0.025 }), {});
    const auto limit = 1.2 * peakVoltage (alone);
    CHECK_NOTHROW (designFocus (model, train ({ 0.025, 0.05 }, 2 * limit), {}));

    try
    {
        designFocus (model, train ({ 0.025, 0.02502 }, limit), {});
        FAIL ("fields of two places 20 us apart need more");
    }
    catch (const LimitError& error)
    {
        CHECK (error.minimumPeakVoltage > limit);
        CHECK (error.reachableVelocity < 0.04);
    }
}

TEST_CASE ("Only the method with exact rows of drives makes trains", "[focus][train]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = train ({ 0.025, 0.035 });

    for (const auto method : { AllocationMethod::paper, AllocationMethod::leastVoltage })
    {
        focus.allocation.method = method;
        CHECK_THROWS_WITH (designFocus (model, focus, {}), Catch::Contains ("focus: targets: have 2 different times"));
    }

    focus.allocation.method = AllocationMethod::paper;
    focus.targets[1].time = 0.025;
    CHECK_NOTHROW (designFocus (model, focus, {}));
}
