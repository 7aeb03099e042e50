#include "Support/SineBeam.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/SpillOver.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

using namespace antinode;

namespace
{
constexpr Playback interface {
    Reconstruction::bandLimited, 96000
};

FocusDescription nearFocus (double x, std::optional<double> timesBound = {})
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, x, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 6;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = timesBound;
    return focus;
}
} // namespace

TEST_CASE ("Least voltage is within a quarter of what any waveform needs, with every mode at its velocity when played",
           "[freeWaveform][leastVoltage]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto x : { -0.061, -0.03, 0.002, 0.02, 0.055 })
    {
        CAPTURE (x);
        const auto design = designFocus (model, nearFocus (x), interface);
        CHECK (peakVoltage (design) <= 1.25 * design.lowerBoundVoltage);
        CHECK (peakVoltage (design) >= design.lowerBoundVoltage);
        CHECK (design.certificate.status == AllocationStatus::optimal);
        RenderSettings settings;
        settings.playback = interface;
        settings.duration = 0.02;
        settings.probeShapes.resize (0, model.modes());
        const auto render = renderOffline (model, design.program, settings);
        const auto largest = design.target.modalVelocities.cwiseAbs().maxCoeff();

        for (const auto mode : design.controlledModes)
            CHECK (render.focusVelocities[mode]
                   == Approx (design.target.modalVelocities[mode]).margin (1e-9 * largest));
    }
}

TEST_CASE ("How near least voltage comes is a choice, and a voltage limit holds too", "[freeWaveform][leastVoltage]")
{
    const auto model = test::sineBeam (20, 8);
    const auto bound = designFocus (model, nearFocus (0.02), interface).lowerBoundVoltage;
    const auto peakAt = [&] (std::optional<double> times, std::optional<double> limit = {})
    {
        auto focus = nearFocus (0.02, times);
        focus.allocation.voltageLimit = limit;
        return peakVoltage (designFocus (model, focus, interface, DesignExtent::playable));
    };
    CHECK (peakAt (1.05) <= 1.05 * bound);
    CHECK (peakAt (2) > 1.6 * bound);
    CHECK (peakAt (2) <= 2 * bound);
    CHECK (peakAt (2, 1.1 * bound) == Approx (1.1 * bound));
    CHECK_THROWS_AS (peakAt (1.25, 0.9 * bound), LimitError);
}

TEST_CASE ("A place that guards what another one needed has that place's design", "[freeWaveform][leastVoltage]")
{
    // A device that says 12 of its 20 modes.
    const WideModel wide { test::sineBeam (20, 8), 12, {}, {} };
    const auto first = designWithin (wide, nearFocus (0.02), interface, DesignExtent::playable);
    const auto beyond = first.spillOver->guardedBeyond;
    const auto again = designGuarding (firstModes (wide.model, 12 + beyond), 12, nearFocus (0.02), interface);
    CHECK (again.program.samples->values == first.program.samples->values);
    CHECK (again.controlledModes == first.controlledModes);
}

// The interface lets through what is below 96 kHz: modes to 185 kHz of a beam of which the device says those to 22.6.
TEST_CASE ("Fast interfaces leave no more in modes beyond than slow ones, within a quarter of the bound",
           "[freeWaveform][leastVoltage]")
{
    const WideModel wide { test::sineBeam (40, 8), 14, {}, {} };
    auto focus = nearFocus (0.02);
    focus.modes.count = 10;

    for (const auto rate : { 96000.0, 192000.0 })
    {
        CAPTURE (rate);
        const auto design = designWithin (wide, focus, { Reconstruction::bandLimited, rate });
        CHECK (peakVoltage (design) <= 1.25 * design.lowerBoundVoltage);
        CHECK (spillOverShare (wide, design) < 0.002);
        RenderSettings settings;
        settings.playback = design.playback;
        settings.duration = 0.02;
        settings.probeShapes.resize (0, wide.model.modes());
        CHECK (spillOverShare (wide, renderOffline (wide.model, design.program, settings).focusVelocities) < 0.002);
    }
}

TEST_CASE ("What least voltage comes to is said in shares of limits, which may differ", "[freeWaveform][leastVoltage]")
{
    auto model = test::sineBeam (20, 8);

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
        model.ceramics[i].voltageLimit = i == 0 ? 150 : 30;

    const auto design = designFocus (model, nearFocus (0.02), interface, DesignExtent::playable);
    double share = 0;

    for (Eigen::Index i = 0; i < 8; ++i)
        share = std::max (share, design.program.samples->values.row (i).cwiseAbs().maxCoeff() / (i == 0 ? 150 : 30));

    const auto sentence =
        std::find_if (design.choices.begin(), design.choices.end(),
                      [] (const std::string& choice) { return choice.starts_with ("Least voltage"); });
    REQUIRE (sentence != design.choices.end());
    CAPTURE (*sentence);
    const auto numberBehind = [&] (const std::string& words)
    { return std::stod (sentence->substr (sentence->find (words) + words.size())); };
    CHECK (numberBehind ("at most ") == Approx (100 * share).epsilon (0.01));
    CHECK (numberBehind ("limit, ") > 1);
    CHECK (numberBehind ("limit, ") <= 1.25);
    CHECK (numberBehind ("times the ") == Approx (100 * share / numberBehind ("limit, ")).epsilon (0.01));
}
