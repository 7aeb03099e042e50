#include "Brake.h"

#include "BrakeProblem.h"
#include "Transients.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double restOfDecay = 1e-3; // of the slowest mode's envelope at the end, where no duration is given
constexpr double brakeFolds = 4;     // by which brakes fall where no decay is given: as the drives rose
constexpr double longest = 1;        // s: what is chosen or lengthened ends there
constexpr double sparedRatio = 1.02, minimumLengthening = 1.05, maximumLengthening = 2;

void append (VoltageProgram& program, const VoltageProgram& more)
{
    const auto before = program.allocation.cols();
    program.allocation.conservativeResize (Eigen::NoChange, before + more.allocation.cols());
    program.allocation.rightCols (more.allocation.cols()) = more.allocation;
    program.oscillations.insert (program.oscillations.end(), more.oscillations.begin(), more.oscillations.end());
}

std::string milliseconds (double time)
{
    return inWords (time * 1000) + " ms";
}

BrakeAttempt requestedAttempt (const FocusDesign& design, const ModalModel& model)
{
    const auto& choice = design.description.transients;
    const auto shortest = 3 * releaseDuration();
    const auto slowest = decayRates (model) (design.controlledModes).minCoeff();
    const auto chosen = -std::log (restOfDecay) / (choice.brake.value_or (1) * slowest);
    const auto duration = choice.brakeDuration.value_or (std::clamp (chosen, shortest, longest));

    if (duration < shortest)
        throw InputError ("focus: brake duration",
                          "is " + milliseconds (duration)
                              + ", too short to release the drives and to start and end a brake; allowed: at least "
                              + milliseconds (shortest));

    return { duration, choice.brake, brakeFolds };
}

Allocation allocate (const BrakeProblem& problem, const ModalModel& model)
{
    if (! problem.modes.empty())
        return solveAllocation (problem.allocation, AllocationGoal::norm);

    return { Eigen::MatrixXd (model.actuators(), 0), {} };
}

bool isEasiest (const BrakeAttempt& attempt)
{
    return ! attempt.brake && attempt.folds == 0 && attempt.duration >= longest;
}

/** The next attempt where the limits do not allow this one: first brakes without decay, which need least, then longer
    ones. */
BrakeAttempt easierThan (const BrakeAttempt& attempt, double peakRatio)
{
    if (attempt.brake || attempt.folds > 0)
        return { attempt.duration, {}, 0 };

    const auto lengthening = std::clamp (sparedRatio * peakRatio, minimumLengthening, maximumLengthening);
    return { std::min (attempt.duration * lengthening, longest), {}, 0 };
}

void addBrakeRemarks (FocusDesign& design, const BrakeAttempt& asked, const BrakeAttempt& taken, std::size_t modes)
{
    auto choice = "Brake: " + std::to_string (modes) + " modes are at rest " + milliseconds (taken.duration)
                  + " after the focus, in velocity and displacement; ";

    if (! design.description.transients.brakeDuration)
        choice += "this duration lets the slowest mode decay to 0.1 %; ";

    if (taken.brake)
        choice += "each mode decays " + inWords (*taken.brake) + " times as fast as freely.";
    else
        choice +=
            taken.folds > 0 ? "all voltages decay together by 4 e-folds." : "the voltages do not decay before that.";

    design.choices.push_back (choice);

    if (taken.duration > asked.duration)
        design.warnings.push_back ("Within the limits the surface cannot be at rest " + milliseconds (asked.duration)
                                   + " after the focus; it is at rest after " + milliseconds (taken.duration) + ".");
    else if (asked.brake && ! taken.brake)
        design.warnings.push_back ("The limits do not allow so fast a brake: the motion decays more slowly "
                                   "at first and is at rest at the same time.");
}
} // namespace

bool hasBrake (const TransientChoice& choice)
{
    return choice.brake.has_value() || choice.brakeDuration.has_value();
}

void appendBrake (FocusDesign& design, const ModalModel& model)
{
    const auto asked = requestedAttempt (design, model);
    auto attempt = asked;
    auto problem = brakeProblem (design, model, attempt);
    auto allocation = allocate (problem, model);

    while (allocation.certificate.status == AllocationStatus::infeasible && ! isEasiest (attempt))
    {
        attempt = easierThan (attempt, allocation.certificate.peakRatio);
        problem = brakeProblem (design, model, attempt);
        allocation = allocate (problem, model);
    }

    addBrakeRemarks (design, asked, attempt, problem.modes.size());

    if (allocation.certificate.status == AllocationStatus::infeasible)
    {
        const auto share = 1 / allocation.certificate.peakRatio;
        allocation.matrix *= share;
        design.warnings.push_back ("The limits allow only " + inWords (100 * share)
                                   + " % of the brake; the remaining motion decays freely.");
    }

    design.restTime = attempt.duration;
    addCounterShares (problem, model, allocation.matrix);
    append (design.program,
            makeProgram (problem.drives, allocation.matrix, design.program.voltageLimits, design.program.focusTime));
}
} // namespace antinode
