#include "Support/LeastPeak.h"
#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

namespace
{
FocusDescription sincFocus (AllocationMethod method, double limit = 150)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 8;
    focus.allocation.method = method;
    focus.allocation.voltageLimit = limit;
    return focus;
}

Eigen::VectorXd velocitiesAt (const ModalModel& model, const FocusDesign& design, double time)
{
    return modalVelocities (model, predictStates (model, design.program, time));
}

double computeFieldError (const ModalModel& model, const FocusDesign& design)
{
    const Eigen::VectorXd field = model.shapes * velocitiesAt (model, design, design.program.focusTime);
    return scoreField (model.surface, field, design.truncatedField).fieldError;
}
} // namespace

TEST_CASE ("Exact rows bring every controlled mode to its velocity to 1e-9", "[focus]")
{
    const auto model = test::sineBeam (20, 8);

    for (const auto limit : { 150.0, 1.01 * test::leastPeakVoltage (model, sincFocus (AllocationMethod::exact)) })
    {
        const auto design = designFocus (model, sincFocus (AllocationMethod::exact, limit), {});
        const auto reached = velocitiesAt (model, design, 0.025);

        for (const auto mode : design.controlledModes)
            CHECK (reached[mode]
                   == Approx (design.target.modalVelocities[mode]).margin (1e-9 * reached.cwiseAbs().maxCoeff()));
    }
}

TEST_CASE ("The paper's rows leave the couplings between modes: small on a beam, but there", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto paper = computeFieldError (model, designFocus (model, sincFocus (AllocationMethod::paper), {}));
    const auto exact = computeFieldError (model, designFocus (model, sincFocus (AllocationMethod::exact), {}));
    CHECK (paper < 0.05);
    CHECK (exact < 0.005);
    CHECK (exact < paper / 2);
}

TEST_CASE ("Soft guards lower the field error and cost hardly any voltage", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = sincFocus (AllocationMethod::exact);
    const auto guarded = designFocus (model, focus, {});
    focus.allocation.guardModes = 0;
    const auto free = designFocus (model, focus, {});
    CHECK (computeFieldError (model, guarded) < computeFieldError (model, free));
    CHECK (peakVoltage (guarded) < 1.2 * peakVoltage (free));
}

TEST_CASE ("The allocation needs less voltage than one ceramic a mode", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    auto strongest = model; // Of each mode, the participation of the ceramic that moves it most.

    for (auto row : strongest.participation.rowwise())
        row = (row.array().abs() == row.array().abs().maxCoeff()).select (row, 0).eval();

    const auto focus = sincFocus (AllocationMethod::paper);
    const auto oneCeramic = peakVoltage (designFocus (strongest, focus, {}));
    const auto leastNorm = peakVoltage (designFocus (model, focus, {}));
    CHECK (leastNorm < oneCeramic);
    CHECK (test::leastPeakVoltage (model, sincFocus (AllocationMethod::exact)) < leastNorm);
}

TEST_CASE ("A limit that cannot be met is refused with what can be reached, and that can be reached", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto minimum = test::leastPeakVoltage (model, sincFocus (AllocationMethod::exact));
    auto focus = sincFocus (AllocationMethod::exact, 0.2 * minimum);

    try
    {
        designFocus (model, focus, {});
        FAIL ("the limit was not refused");
    }
    catch (const LimitError& error)
    {
        CHECK_THAT (error.what(), Catch::Contains ("focus: voltage limit: is ")
                                      && Catch::Contains ("these drives need at least")
                                      && Catch::Contains ("this limit allows "));
        CHECK (error.minimumPeakVoltage == Approx (minimum).epsilon (2e-3));
        CHECK (error.reachableVelocity == Approx (0.2 * 0.04).epsilon (2e-3));
        focus.targets[0].peakVelocity = 0.998 * error.reachableVelocity;
        CHECK_NOTHROW (designFocus (model, focus, {}));
    }
}

TEST_CASE ("A limit that one drive a mode cannot keep is kept with more of them, down to where these end", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto minimum = test::leastPeakVoltage (model, sincFocus (AllocationMethod::exact));
    const auto plain = designFocus (model, sincFocus (AllocationMethod::exact, 1.05 * minimum), {});
    const auto rich = designFocus (model, sincFocus (AllocationMethod::exact, 0.8 * minimum), {});
    CHECK (peakVoltage (plain) <= 1.05 * minimum);
    CHECK (peakVoltage (rich) <= 0.8 * minimum);
    CHECK (rich.program.oscillations.size() == 4 * plain.program.oscillations.size());

    auto described = sincFocus (AllocationMethod::exact, 0.8 * minimum);
    described.transients.drive = DriveKind::paper; // Has no further drives.
    CHECK_THROWS_AS (designFocus (model, described, {}), LimitError);
}

TEST_CASE ("Within an active limit the voltages touch it and the duality gap is certified", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    const auto minimum = test::leastPeakVoltage (model, sincFocus (AllocationMethod::exact));
    const auto design = designFocus (model, sincFocus (AllocationMethod::exact, 1.05 * minimum), {});
    CHECK (design.certificate.status == AllocationStatus::optimal);
    CHECK (design.certificate.gap <= 1e-6);
    CHECK (design.certificate.gap >= -1e-9);
    CHECK (design.certificate.peakRatio == Approx (1).epsilon (1e-6));
    CHECK (design.lowerBoundVoltage > 0);
    CHECK (design.lowerBoundVoltage < minimum);
}

TEST_CASE ("Exact rows need at most 1.06 of the least peak of the paper's rows, also where modes are close", "[focus]")
{
    test::SinePlate plate;
    plate.lengthY = 0.199; // Nearly a square: modes in pairs.
    const auto model = plate.model (40);
    FocusDescription focus;
    focus.targets = { { TargetShape::bump, 0.07, 0.06, 0.03, 0.02, 1 } };
    focus.focusTime = 0.02;
    focus.modes.count = 15;

    focus.allocation.method = AllocationMethod::paper;
    const auto paper = test::leastPeakVoltage (model, focus);
    focus.allocation.voltageLimit = 1.06 * paper;
    focus.allocation.method = AllocationMethod::exact;
    CHECK (test::leastPeakVoltage (model, focus) > 1.06 * paper); // One drive a mode does not do.
    const auto design = designFocus (model, focus, {});
    CHECK (peakVoltage (design) <= 1.06 * paper);
    CHECK (design.program.oscillations.size() == 4 * 3 * design.controlledModes.size());
    const auto reached = velocitiesAt (model, design, focus.focusTime);

    for (const auto mode : design.controlledModes)
        CHECK (reached[mode]
               == Approx (design.target.modalVelocities[mode]).margin (1e-9 * reached.cwiseAbs().maxCoeff()));
}

TEST_CASE ("At the paper's growth of 4 the offset-free drive needs less voltage than the paper's", "[focus]")
{
    const auto model = withoutVoltageLimits (test::sineBeam (20, 8));
    auto focus = sincFocus (AllocationMethod::paper, noVoltageLimit);
    focus.transients.growth = { 4 };
    const auto offsetFree = peakVoltage (designFocus (model, focus, {}));
    focus.transients.drive = DriveKind::paper;
    CHECK (peakVoltage (designFocus (model, focus, {})) > 1.3 * offsetFree);
}

TEST_CASE ("The brake takes the field down faster than free decay", "[focus]")
{
    const auto model = test::sineBeam (20, 8, 100);
    auto focus = sincFocus (AllocationMethod::exact);
    const auto norm = [&] (const FocusDesign& design, double time)
    { return velocitiesAt (model, design, time) (design.controlledModes).norm(); };
    const auto free = designFocus (model, focus, {});
    focus.transients.brake = 40;
    const auto braked = designFocus (model, focus, {});
    CHECK (norm (braked, 0.025) == Approx (norm (free, 0.025)).epsilon (0.01));
    CHECK (norm (braked, 0.06) < 0.1 * norm (free, 0.06));
    // Brakes are two a mode: a decaying part, two for its onset, two for its release.
    const auto brakes = std::count_if (braked.program.oscillations.begin(), braked.program.oscillations.end(),
                                       [] (const Oscillation& oscillation) { return oscillation.isBrake(); });
    CHECK (brakes > 0);
    CHECK (brakes % 10 == 0);
}

TEST_CASE ("Impossible requests are refused with the field", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = sincFocus (AllocationMethod::exact);
    focus.targets[0].x = 0.2;
    CHECK_THROWS_WITH (designFocus (model, focus, {}),
                       Catch::Contains ("focus: target 1 x: is 200 mm, which is outside the surface; allowed: "));
    focus = sincFocus (AllocationMethod::exact);
    focus.modes.count = 20;
    CHECK_THROWS_WITH (designFocus (model, focus, { Reconstruction::bandLimited, 48000 }),
                       Catch::Contains ("sample rate: is 48000 Hz, too low for mode 15"));
    auto bare = test::sineBeam (20, 0);
    CHECK_THROWS_WITH (designFocus (bare, sincFocus (AllocationMethod::exact), {}),
                       Catch::Contains ("has no ceramics"));
}

TEST_CASE ("Warnings tell of a poor capture and of a limit that clips", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = sincFocus (AllocationMethod::paper);
    focus.modes.count = 2;
    focus.transients.growth = { 0 };
    focus.allocation.window = 5e-5; // Before it the drives are as large, and not limited.
    focus.allocation.voltageLimit = 1.05 * test::leastPeakVoltage (model, focus);
    const auto warnings = designFocus (model, focus, {}).warnings;
    REQUIRE (warnings.size() == 2);
    CHECK_THAT (warnings[0], Catch::Contains ("represent only"));
    CHECK_THAT (warnings[1], Catch::Contains ("limiter will clip"));
}

TEST_CASE ("Warnings tell of a y on a line, and of less felt where the focus is", "[focus][felt]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = sincFocus (AllocationMethod::exact);
    const auto usual = designFocus (model, focus, {}).warnings.size();
    const auto& target = focus.targets.front();
    focus.felt.emplace();
    focus.felt->at = FeltAt::places;
    focus.felt->places = { { target.x + 0.4 * target.width, 0 }, { target.x + target.width, 0 } };
    auto warnings = designFocus (model, focus, {}).warnings;
    REQUIRE (warnings.size() == usual + 1);
    CHECK_THAT (warnings[0], Catch::Contains ("'felt': place 1 lies") && Catch::Contains ("from target 1"));

    focus.felt.reset();
    focus.targets[0].y = 0.01;
    warnings = designFocus (model, focus, {}).warnings;
    REQUIRE (warnings.size() == usual + 1);
    CHECK (warnings[0] == "y of target 1, 10 mm, is ignored: the surface of 'sine beam' is a line.");
}

TEST_CASE ("A detuned model is reproducible and as far off as asked for", "[focus]")
{
    const auto model = test::sineBeam (200, 8);
    const auto plate = detuned (model, { 0.002, 0.1, 0.05 }, 7);
    CHECK (plate.angularFrequencies == detuned (model, { 0.002, 0.1, 0.05 }, 7).angularFrequencies);
    CHECK (plate.angularFrequencies != detuned (model, { 0.002, 0.1, 0.05 }, 8).angularFrequencies);
    const Eigen::ArrayXd off = plate.angularFrequencies.array() / model.angularFrequencies.array() - 1;
    CHECK (std::sqrt (off.square().mean()) == Approx (0.002).epsilon (0.2));
    const Eigen::ArrayXd damping = plate.dampingRatios.array() / model.dampingRatios.array() - 1;
    CHECK (std::sqrt (damping.square().mean()) == Approx (0.1).epsilon (0.2));
    CHECK (detuned (model, {}, 7).participation == model.participation);
}

TEST_CASE ("Displacements of the controlled modes are 0 at the focus where that is asked for", "[focus]")
{
    const auto model = test::sineBeam (20, 8);
    auto focus = sincFocus (AllocationMethod::exact);
    const auto free = designFocus (model, focus, {});
    focus.allocation.isUndisplaced = true;
    const auto design = designFocus (model, focus, {});
    const auto largestDisplacement = [&] (const FocusDesign& any)
    {
        const auto states = predictStates (model, any.program, any.program.focusTime);
        return states.imag() (any.controlledModes).cwiseAbs().maxCoeff();
    };
    const auto velocities = velocitiesAt (model, design, 0.025);
    CHECK (largestDisplacement (design) <= 1e-9 * velocities.cwiseAbs().maxCoeff());
    CHECK (largestDisplacement (free) > 1e-4 * velocities.cwiseAbs().maxCoeff());
    CHECK (computeFieldError (model, design) < 0.005);
}

TEST_CASE ("Slew limits of the ceramics hold at every instant, and those out of reach are named", "[focus]")
{
    auto model = test::sineBeam (20, 8);
    const auto free = designFocus (model, sincFocus (AllocationMethod::exact), {});
    const auto steepest = [] (const VoltageProgram& program)
    {
        Eigen::VectorXd slopes = Eigen::VectorXd::Zero (program.allocation.rows());

        for (double time = 0; time < 0.036; time += 1e-6)
        {
            Eigen::VectorXd values (program.oscillations.size());

            for (Eigen::Index c = 0; c < values.size(); ++c)
            {
                const auto& oscillation = program.oscillations[static_cast<std::size_t> (c)];
                const auto isOn = time >= oscillation.start && time < oscillation.end;
                const auto p = oscillation.exponent();
                values[c] = isOn ? (p * oscillation.phasor() * std::exp (p * (time - oscillation.start))).real() : 0.0;
            }

            slopes = slopes.cwiseMax ((program.allocation * values).cwiseAbs());
        }

        return slopes;
    };
    const auto limit = 0.9 * steepest (free.program).maxCoeff();

    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = limit;

    model.ceramics[2].slewLimit = 0;
    const auto slewed = designFocus (model, sincFocus (AllocationMethod::exact), {});
    const auto slopes = steepest (slewed.program);

    for (Eigen::Index i = 0; i < slopes.size(); ++i)
        if (i != 2)
            CHECK (slopes[i] <= limit);

    CHECK (slopes.maxCoeff() >= 0.95 * limit);
    CHECK (peakVoltage (slewed) == Approx (peakVoltage (free)).epsilon (0.2)); // Volts, not parts of what is limited.
    CHECK (slewed.certificate.objective >= free.certificate.objective);

    auto braked = sincFocus (AllocationMethod::exact);
    braked.transients.brakeDuration = 0.01;
    model.ceramics[2].slewLimit = limit;
    CHECK (steepest (designFocus (model, braked, {}).program).maxCoeff() <= limit);

    auto any = sincFocus (AllocationMethod::leastVoltage);
    CHECK_THROWS_WITH (designFocus (model, any, { Reconstruction::zeroOrderHold, 96000 }),
                       Catch::Contains ("reconstruction: holds samples"));

    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = 0.01 * limit;

    CHECK_THROWS_WITH (designFocus (model, sincFocus (AllocationMethod::exact), {}), Catch::Contains ("slew"));
}
