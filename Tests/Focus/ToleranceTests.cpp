#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/Tolerance.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace antinode;

namespace
{
FocusDesign sincDesign (const ModalModel& model, AllocationMethod method = AllocationMethod::exact)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 8;
    focus.allocation.voltageLimit = 150;
    focus.allocation.method = method;
    const auto isSampled = method == AllocationMethod::leastVoltage;
    const auto playback = isSampled ? Playback { Reconstruction::bandLimited, 48000 } : Playback {};
    return designFocus (model, focus, playback, DesignExtent::playable);
}

void ignore (double) {}

double rootMeanSquare (const std::vector<FocusScore>& scores)
{
    double sum = 0;

    for (const auto& score : scores)
        sum += score.fieldError * score.fieldError;

    return std::sqrt (sum / static_cast<double> (scores.size()));
}

/** The field error of a design on another device, not through any code of the tolerance. */
double errorOn (const ModalModel& device, const FocusDesign& design)
{
    const auto states = predictStates (device, design.program, design.program.focusTime);
    return scoreField (device.surface, device.shapes * modalVelocities (device, states), design.truncatedField)
        .fieldError;
}

double causeError (const std::vector<ToleranceCause>& causes, int mode, ToleranceKind kind)
{
    const auto found =
        std::find_if (causes.begin(), causes.end(),
                      [&] (const ToleranceCause& cause) { return cause.mode == mode && cause.kind == kind; });
    return found == causes.end() ? -1 : found->fieldError;
}
} // namespace

TEST_CASE ("Percentiles interpolate between ordered values", "[tolerance]")
{
    // 0 to 100 in steps of 10: the p-th percentile is p.
    std::vector<double> values;

    for (int i = 10; i >= 0; --i)
        values.push_back (10.0 * i);

    const auto result = computePercentiles (values);

    for (std::size_t i = 0; i < result.size(); ++i)
        CHECK (result[i] == Approx (tolerancePercents[i]));

    CHECK (computePercentiles ({ 7 })[2] == 7);
}

TEST_CASE ("The same seed draws the same devices, another seed others", "[tolerance]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = sincDesign (model);
    const auto first = evaluateTolerance (model, design, { usualSpread, 30, 1 }, ignore);
    const auto again = evaluateTolerance (model, design, { usualSpread, 30, 1 }, ignore);
    const auto other = evaluateTolerance (model, design, { usualSpread, 30, 2 }, ignore);
    CHECK (first.vScore == again.vScore);
    CHECK (first.fieldError == again.fieldError);
    CHECK (first.fieldError != other.fieldError);

    // More draws go on where fewer ended.
    const auto fewer = evaluateTolerance (model, design, { usualSpread, 10, 1 }, ignore);

    for (std::size_t i = 0; i < fewer.draws.size(); ++i)
        CHECK (fewer.draws[i].fieldError == first.draws[i].fieldError);
}

TEST_CASE ("Without spread every device is the known one", "[tolerance]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = sincDesign (model);
    const auto tolerance = evaluateTolerance (model, design, { DetuningSpread {}, 5, 1 }, ignore);
    CHECK (tolerance.known.fieldError == Approx (errorOn (model, design)));
    CHECK (tolerance.causes.empty());

    for (const auto& score : tolerance.draws)
        CHECK (score.fieldError == tolerance.known.fieldError);
}

TEST_CASE ("What each cause costs alone adds up in squares to what the devices drawn show", "[tolerance]")
{
    // Modes are orthogonal on this beam, and errors independent; what is left are the draws' own deviation (300 draws:
    // 4 % of the mean square at one standard deviation, for errors spread over some ten causes) and the product of
    // errors of one mode.
    const auto model = test::sineBeam (20, 8);
    const auto design = sincDesign (model, GENERATE (AllocationMethod::exact, AllocationMethod::leastVoltage));
    const auto tolerance = evaluateTolerance (model, design, { { 0.002, 0.1, 0.05, 0 }, 300, 1 }, ignore);
    double sum = tolerance.known.fieldError * tolerance.known.fieldError;

    for (const auto& cause : tolerance.causes)
        sum += cause.fieldError * cause.fieldError;

    CHECK (std::sqrt (sum) == Approx (rootMeanSquare (tolerance.draws)).epsilon (0.1));
    CHECK (std::is_sorted (tolerance.causes.begin(), tolerance.causes.end(),
                           [] (const ToleranceCause& a, const ToleranceCause& b)
                           { return a.fieldError > b.fieldError; }));
}

TEST_CASE ("A cause is what devices show that are off in that one thing", "[tolerance]")
{
    // Small errors: the response is all but linear in damping, so that 1 standard deviation either way stands for the
    // RMS.
    const auto model = test::sineBeam (20, 8);
    const auto design = sincDesign (model);
    const auto mode = design.controlledModes[3];
    const auto causes = toleranceCauses (model, design, { 0, 0.01, 0.01, 0 });
    auto damped = model;
    damped.dampingRatios[mode] *= 1.01;
    const Eigen::VectorXd known = model.shapes * modalVelocities (model, predictStates (model, design.program, 0.025));
    const Eigen::VectorXd off = damped.shapes * modalVelocities (damped, predictStates (damped, design.program, 0.025));
    const auto change = [&] (const Eigen::VectorXd& field)
    {
        const auto squares = [&] (const Eigen::VectorXd& v) { return model.surface.areas.dot (v.cwiseAbs2()); };
        return std::sqrt (squares (field - known) / squares (design.truncatedField));
    };
    CHECK (causeError (causes, mode, ToleranceKind::damping) == Approx (change (off)).epsilon (0.01));
    CHECK (causeError (causes, mode, ToleranceKind::frequency) == -1);

    // Participations are linear: the squares of one ceramic at a time add up.
    double sum = 0;

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
    {
        auto moved = model;
        moved.participation (mode, i) *= 1.01;
        const Eigen::VectorXd field =
            model.shapes * modalVelocities (moved, predictStates (moved, design.program, 0.025));
        sum += change (field) * change (field);
    }

    CHECK (causeError (causes, mode, ToleranceKind::participation) == Approx (std::sqrt (sum)).epsilon (1e-6));
}

TEST_CASE ("A drift moves all frequencies alike and costs what devices show that have drifted", "[tolerance]")
{
    const auto model = test::sineBeam (20, 8);
    const auto design = sincDesign (model);
    const auto device = detuned (model, { 0, 0, 0, 0.001 }, 5);
    const Eigen::VectorXd factors = device.angularFrequencies.cwiseQuotient (model.angularFrequencies);
    CHECK (factors.maxCoeff() - factors.minCoeff() < 1e-14);
    CHECK (std::abs (factors[0] - 1) > 1e-5);

    const auto tolerance = evaluateTolerance (model, design, { { 0, 0, 0, 0.001 }, 400, 1 }, ignore);
    REQUIRE (tolerance.causes.size() == 1);
    CHECK (! tolerance.causes[0].mode);

    // Fourth powers of normal numbers: the mean square of 400 draws is known to 8 % or so.
    CHECK (tolerance.causes[0].fieldError == Approx (rootMeanSquare (tolerance.draws)).epsilon (0.15));
}

TEST_CASE ("A cause is told in a sentence", "[tolerance]")
{
    const auto model = test::sineBeam (20, 8);
    CHECK (causeSentence ({ 6, ToleranceKind::frequency, 0.00812 }, model)
           == "Mode 7 (5657 Hz): its frequency alone changes the field by 0.81 %.");
    CHECK (causeSentence ({ 0, ToleranceKind::participation, 0.05 }, model)
           == "Mode 1 (115 Hz): its participations alone change the field by 5 %.");
    CHECK (causeSentence ({ {}, ToleranceKind::drift, 0.012 }, model)
           == "A drift of all frequencies alone changes the field by 1.2 %.");
}
