#include "Support/LeastPeak.h"
#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FocusDescription focusOfSinc (AllocationMethod method = AllocationMethod::exact)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 8;
    focus.allocation.method = method;
    return focus;
}

/** The voltages of a whole event, resampled so finely that differences are slopes: a tenth of a degree of the highest
    mode here, 7 kHz. */
Render finelyRendered (const ModalModel& model, const FocusDesign& design)
{
    RenderSettings settings;
    settings.playback = { Reconstruction::bandLimited, 2e6 };
    settings.duration = 0.05;
    settings.probeShapes = model.shapes.topRows (1);
    return renderOffline (model, design.program, settings);
}

struct Steepest
{
    int ceramic = 0;
    double slope = 0, time = 0; // V/s; s after the focus
};

/** The largest difference from sample to sample. */
Steepest steepestOf (const ModalModel& model, const FocusDesign& design)
{
    const auto render = finelyRendered (model, design);
    Steepest found;

    for (Eigen::Index i = 0; i < render.voltages.rows(); ++i)
        for (Eigen::Index n = 1; n < render.voltages.cols(); ++n)
            if (const auto slope = std::abs (render.voltages (i, n) - render.voltages (i, n - 1)) * render.sampleRate;
                slope > found.slope)
                found = { static_cast<int> (i), slope,
                          (static_cast<double> (n - render.focusSample) - 0.5) / render.sampleRate };

    return found;
}

double peakOf (const Render& render)
{
    return render.voltages.cwiseAbs().maxCoeff();
}

/** A beam whose amplifiers charge so much with so little, as a description says it. */
ModalModel chargedBeam (double capacitance, double current)
{
    auto model = test::sineBeam (20, 8);

    for (auto& ceramic : model.ceramics)
    {
        ceramic.capacitance = capacitance;
        ceramic.currentLimit = current;
        ceramic.slewLimit = current / capacitance;
    }

    return model;
}
} // namespace

TEST_CASE ("A full scale below the voltage limit limits a design like a voltage limit of the same volts", "[focus]")
{
    auto model = test::sineBeam (20, 8);
    const auto minimum = test::leastPeakVoltage (model, focusOfSinc());
    model.fullScaleVoltage = 1.05 * minimum;
    const auto scaled = designFocus (model, focusOfSinc(), {});
    auto described = focusOfSinc();
    described.allocation.voltageLimit = 1.05 * minimum;
    const auto limited = designFocus (test::sineBeam (20, 8), described, {});
    CHECK (scaled.program.allocation == limited.program.allocation);
    CHECK (scaled.program.voltageLimits == limited.program.voltageLimits);

    const auto render = finelyRendered (model, scaled);
    CHECK (peakOf (render) <= model.fullScaleVoltage);
    REQUIRE (scaled.limit);
    CHECK (scaled.limit->kind == LimitKind::fullScale);
    CHECK (limited.limit->kind == LimitKind::focus);
    CHECK (scaled.limit->used == Approx (peakOf (render)).epsilon (1e-3));
    CHECK_THAT (limitSentence (model, *scaled.limit),
                Catch::StartsWith ("The full scale of the device binds: ceramic "));
}

TEST_CASE ("A full scale above the voltage limit changes nothing, to the bit", "[focus]")
{
    auto model = test::sineBeam (20, 8);
    const auto one = designFocus (model, focusOfSinc(), {});
    model.fullScaleVoltage = 400;
    const auto other = designFocus (model, focusOfSinc(), {});
    CHECK (one.program.allocation == other.program.allocation);
    CHECK (one.program.voltageLimits == other.program.voltageLimits);
    CHECK (other.limit->kind == LimitKind::ceramic);
    CHECK_FALSE (isReached (*other.limit));
    CHECK_THAT (limitSentence (model, *other.limit),
                Catch::StartsWith ("No limit binds; the nearest is the voltage limit of the ceramic: ceramic "));
}

TEST_CASE ("What an amplifier gives at full scale stands for the device's full scale at its ceramic", "[model]")
{
    auto model = test::sineBeam (20, 3);
    model.fullScaleVoltage = 2;
    model.ceramics[1].amplifierVoltage = 1;
    model.ceramics[2].amplifierVoltage = 600;
    CHECK (voltageLimits (model) == Eigen::Vector3d (2, 1, 150));
    CHECK (voltageLimitKind (model, {}, 0) == LimitKind::fullScale);
    CHECK (voltageLimitKind (model, {}, 1) == LimitKind::amplifier);
    CHECK (voltageLimitKind (model, {}, 2) == LimitKind::ceramic);
    AllocationChoice choice;
    choice.voltageLimit = 1.5;
    CHECK (voltageLimitKind (model, choice, 0) == LimitKind::focus);
    CHECK (voltageLimitKind (model, choice, 1) == LimitKind::amplifier);
}

TEST_CASE ("A current limit is reported in mA, with its ceramic and time, as the differences of the voltages have it",
           "[focus]")
{
    constexpr auto capacitance = 20e-9;
    const auto unlimited = chargedBeam (capacitance, 10);
    const auto needed = capacitance * steepestOf (unlimited, designFocus (unlimited, focusOfSinc(), {})).slope;
    const auto model = chargedBeam (capacitance, 0.8 * needed);
    const auto design = designFocus (model, focusOfSinc(), {});
    const auto steepest = steepestOf (model, design);
    REQUIRE (design.limit);
    const auto& limit = *design.limit;
    CHECK (limit.kind == LimitKind::current);
    CHECK (limit.allowed == 0.8 * needed);
    CHECK (limit.used == Approx (capacitance * steepest.slope).epsilon (2e-3));
    CHECK (limit.used <= limit.allowed);
    CHECK (isReached (limit));
    CHECK_THAT (limitSentence (model, limit), Catch::StartsWith ("The current limit binds: ceramic ")
                                                  && Catch::Contains (" mA of ") && Catch::Contains (" the focus."));

    // Several ceramics touch the limit: what is named is one of them, and at its time.
    const auto render = finelyRendered (model, design);
    const auto n = render.focusSample + std::lround (limit.time * render.sampleRate);
    const auto there = std::abs (render.voltages (limit.ceramic, n + 1) - render.voltages (limit.ceramic, n - 1)) / 2
                       * render.sampleRate * capacitance;
    CHECK (there == Approx (limit.used).epsilon (2e-3));
}

TEST_CASE ("A slew limit holds from the first sample on, however short the drives and steep their envelopes", "[focus]")
{
    for (const auto method : { AllocationMethod::exact, AllocationMethod::paper })
        for (const auto kind : { DriveKind::offsetFree, DriveKind::paper })
        {
            auto focus = focusOfSinc (method);
            focus.focusTime = 0.004;
            focus.transients.drive = kind;
            const auto unlimited = chargedBeam (20e-9, 10);
            const auto needed = steepestOf (unlimited, designFocus (unlimited, focus, {})).slope;
            const auto model = chargedBeam (20e-9, 0.9 * needed * 20e-9);
            const auto steepest = steepestOf (model, designFocus (model, focus, {}));
            CHECK (steepest.slope <= 0.9 * needed);
        }
}

TEST_CASE ("The current of a design far below its limit is that of the steepest ceramic, at its time", "[focus]")
{
    constexpr auto capacitance = 20e-9;
    auto model = chargedBeam (capacitance, 10);

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = 1e5;

    model.fullScaleVoltage = 1e5;
    const auto design = designFocus (model, focusOfSinc(), {});
    const auto steepest = steepestOf (model, design);
    const auto uses = limitUses (model, {}, design.program);
    REQUIRE (uses.slew);
    CHECK (uses.slew->ceramic == steepest.ceramic);
    CHECK (uses.slew->used == Approx (capacitance * steepest.slope).epsilon (1e-3));
    CHECK (uses.slew->time == Approx (steepest.time).margin (2e-6));
    CHECK (uses.voltage.used == Approx (peakOf (finelyRendered (model, design))).epsilon (1e-3));
}

TEST_CASE ("A slew limit is reported in V/us where it was given, or is lower than what the current allows", "[focus]")
{
    auto model = chargedBeam (20e-9, 1);

    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = 1e4;

    auto focus = focusOfSinc (AllocationMethod::paper);
    focus.allocation.window = 0.0002;
    const auto design = designFocus (model, focus, {});
    const auto steepest = steepestOf (model, design);
    REQUIRE (design.limit);
    CHECK (design.limit->kind == LimitKind::slew);
    CHECK (design.limit->used == Approx (steepest.slope).epsilon (1e-3));
    CHECK (design.limit->share() > 1);
    CHECK_THAT (limitSentence (model, *design.limit),
                Catch::StartsWith ("The slew limit is exceeded: ceramic ") && Catch::Contains (" V/us of 0.01 V/us, "));
    CHECK_THAT (design.warnings.back(),
                Catch::Contains (" V/us at ceramic ") && Catch::Contains ("; the amplifier will not follow"));
}

TEST_CASE ("A current that is too low is refused in mA, with what the drives need, and what it allows can be reached",
           "[focus]")
{
    constexpr auto capacitance = 20e-9;
    const auto free = designFocus (test::sineBeam (20, 8), focusOfSinc(), {});
    const auto current = 0.1 * capacitance * steepestOf (test::sineBeam (20, 8), free).slope;
    const auto model = chargedBeam (capacitance, current);

    try
    {
        designFocus (model, focusOfSinc(), {});
        FAIL ("the limit was not refused");
    }
    catch (const LimitError& error)
    {
        CHECK_THAT (error.what(), Catch::StartsWith ("device: current limit: is ")
                                      && Catch::Contains (" mA, too low for 40 mm/s: ")
                                      && Catch::Contains (" needs at least ") && Catch::Contains (" the focus"));
        auto slower = focusOfSinc();
        slower.targets[0].peakVelocity = 0.998 * error.reachableVelocity;
        const auto design = designFocus (model, slower, {});
        CHECK (capacitance * steepestOf (model, design).slope <= current * (1 + 1e-9));
    }
}
