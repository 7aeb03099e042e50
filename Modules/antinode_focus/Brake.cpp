#include "Brake.h"

#include "BrakeDrives.h"
#include "DesignRemarks.h"
#include "DriveGrid.h"
#include "Prediction.h"
#include "StateRows.h"
#include "Transients.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double restOfDecay = 1e-3; // of the slowest mode's envelope at the end, where no duration is given
constexpr double envelopeFolds = 4;  // by which brakes fall where no decay is given: as the drives rose
constexpr double nothingLeft = 2e-5; // of the peak field: a mode that would add less by then is not braked
constexpr double longest = 1;        // s: what is chosen or lengthened ends there
constexpr double sparedRatio = 1.02, leastLengthening = 1.05, mostLengthening = 2;

/** One way to brake. */
struct Attempt
{
    double duration = 0;         ///< T_b, s after the last focus.
    std::optional<double> brake; ///< gamma'; none: one envelope for all modes,
    double folds = 0;            ///< which falls by so many e-folds.
};

/** An attempt worked out. */
struct BrakeProblem
{
    std::vector<int> modes;
    DriveList drives; ///< Two a mode.
    AllocationProblem allocation;
};

double lastFocus (const FocusDesign& design)
{
    return design.moments.back().time;
}

/** The first time on the grid of the samples, not before `time`: held samples have exact rows on it. */
double onSample (double time, const FocusDesign& design)
{
    const auto rate = design.playback.sampleRate;
    const auto focus = design.program.focusTime;
    return rate > 0 ? focus + std::ceil ((time - focus) * rate - 1e-6) / rate : time;
}

/** Velocities, then displacements. */
std::vector<StateRow> stateRows (double time, const std::vector<int>& modes)
{
    auto rows = rowsAt (time, modes, ModalQuantity::velocity);
    const auto displacements = rowsAt (time, modes, ModalQuantity::displacement);
    rows.insert (rows.end(), displacements.begin(), displacements.end());
    return rows;
}

Eigen::MatrixXd stateParticipation (const ModalModel& model, const std::vector<int>& modes)
{
    return model.participation (modes, Eigen::all).replicate (2, 1);
}

/** Velocities of modes, then their displacements as rows have them. */
Eigen::VectorXd motionOf (const Eigen::VectorXcd& states, const ModalModel& model, const std::vector<int>& modes)
{
    const Eigen::VectorXd velocities = modalVelocities (model, states) (modes), displacements = states.imag() (modes);
    Eigen::VectorXd motion (velocities.size() + displacements.size());
    motion << velocities, displacements;
    return motion;
}

/** What the drives leave of the motion of given modes at a time. */
Eigen::VectorXd freeMotion (const FocusDesign& design, const ModalModel& model, double time,
                            const std::vector<int>& modes)
{
    if (design.program.samples)
        return motionOf (predictStates (model, design.program, time), model, modes);

    DriveList single;

    for (const auto& oscillation : design.program.oscillations)
        single.push_back ({ oscillation });

    const Eigen::MatrixXd forces = stateParticipation (model, modes) * design.program.allocation;
    return rowResponses (model, stateRows (time, modes), single, design.playback).cwiseProduct (forces).rowwise().sum();
}

/** Of all modes those that by themselves would still move the surface at a time, and the others. */
std::pair<std::vector<int>, std::vector<int>> movingModes (const FocusDesign& design, const ModalModel& model,
                                                           double time)
{
    std::vector<int> all (static_cast<std::size_t> (model.modes())), others;
    std::iota (all.begin(), all.end(), 0);
    const auto motion = freeMotion (design, model, time, all);
    const auto stillMoves = [&] (int k)
    {
        const auto size =
            std::hypot (motion[k], motion[model.modes() + k]) * model.shapes.col (k).cwiseAbs().maxCoeff();
        return size > nothingLeft * design.reachablePeakVelocity;
    };
    std::copy_if (all.begin(), all.end(), std::back_inserter (others), [&] (int k) { return ! stillMoves (k); });
    std::erase_if (all, [&] (int k) { return ! stillMoves (k); });
    return { all, others };
}

DriveList drivesFor (const Attempt& attempt, const ModalModel& model, const std::vector<int>& modes, double focus)
{
    const auto decay = decayRates (model);
    const auto frequency = dampedFrequencies (model);
    BrakeWindow window { focus + releaseDuration(), focus + attempt.duration, 0 };
    DriveList drives;

    for (const auto k : modes)
    {
        const auto common = attempt.folds / (window.end - window.start);
        window.decay = attempt.brake ? std::min (*attempt.brake * decay[k], releaseRate()) : common;

        for (auto& drive : brakeDrives (k, decay[k], frequency[k], window))
            drives.push_back (std::move (drive));
    }

    return drives;
}

BrakeProblem problemFor (const FocusDesign& design, const ModalModel& model, const Attempt& attempt)
{
    const auto end = lastFocus (design) + attempt.duration;
    const auto rest = onSample (end, design);
    const auto [modes, guards] = movingModes (design, model, rest);
    BrakeProblem problem { modes, drivesFor (attempt, model, modes, lastFocus (design)), {} };

    if (modes.empty())
        return problem;

    auto& allocation = problem.allocation;
    limitDrives (allocation, model, design.program.voltageLimits, problem.drives,
                 { lastFocus (design) + releaseDuration(), end });
    allocation.participation = stateParticipation (model, modes);
    allocation.rows = rowResponses (model, stateRows (rest, modes), problem.drives, design.playback);
    allocation.wanted = -freeMotion (design, model, rest, modes);
    allocation.guardParticipation = stateParticipation (model, guards);
    allocation.guardRows = rowResponses (model, stateRows (rest, guards), problem.drives, design.playback);
    allocation.guardWeight = design.description.allocation.guardWeight;
    return problem;
}

/** Tells every brake what a later begin must know of it. */
void addCounterShares (BrakeProblem& problem, const ModalModel& model, const Eigen::MatrixXd& matrix)
{
    const auto poles = modalPoles (model);

    for (std::size_t i = 0; i < problem.modes.size(); ++i)
    {
        const auto k = problem.modes[i];
        const Eigen::RowVectorXd forces =
            model.participation.row (k) * matrix.middleCols (2 * static_cast<Eigen::Index> (i), 2);
        const DriveList own { problem.drives[2 * i], problem.drives[2 * i + 1] };
        const auto share = counterShare (poles[k], own, { forces[0], -forces[1] });

        for (auto drive = 2 * i; drive < 2 * i + 2; ++drive)
            for (auto& oscillation : problem.drives[drive])
                oscillation.counterShare = share;
    }
}

void append (VoltageProgram& program, const VoltageProgram& more)
{
    const auto before = program.allocation.cols();
    program.allocation.conservativeResize (Eigen::NoChange, before + more.allocation.cols());
    program.allocation.rightCols (more.allocation.cols()) = more.allocation;
    program.oscillations.insert (program.oscillations.end(), more.oscillations.begin(), more.oscillations.end());
}

Attempt attemptAsAsked (const FocusDesign& design, const ModalModel& model)
{
    const auto& choice = design.description.transients;
    const auto shortest = 3 * releaseDuration();
    const auto slowest = decayRates (model) (design.controlledModes).minCoeff();
    const auto chosen = -std::log (restOfDecay) / (choice.brake.value_or (1) * slowest);
    const auto duration = choice.brakeDuration.value_or (std::clamp (chosen, shortest, longest));

    if (duration < shortest)
        throw InputError ("focus: /transients/brake_duration_ms",
                          "is " + inWords (duration * 1000)
                              + ", too short to release the drives and to begin and end a brake: allowed is at least "
                              + inWords (shortest * 1000));

    return { duration, choice.brake, envelopeFolds };
}

Allocation allocate (const BrakeProblem& problem, const ModalModel& model, const AllocationWatch& watch)
{
    if (! problem.modes.empty())
        return solveAllocation (problem.allocation, AllocationGoal::norm, watch);

    return { Eigen::MatrixXd (model.actuators(), 0), {} };
}

bool isEasiest (const Attempt& attempt)
{
    return ! attempt.brake && attempt.folds == 0 && attempt.duration >= longest;
}

/** What to try where the limits do not allow an attempt: first brakes that do not fall, which need least, then longer ones. */
Attempt easierThan (const Attempt& attempt, double peakRatio)
{
    if (attempt.brake || attempt.folds > 0)
        return { attempt.duration, {}, 0 };

    const auto lengthening = std::clamp (sparedRatio * peakRatio, leastLengthening, mostLengthening);
    return { std::min (attempt.duration * lengthening, longest), {}, 0 };
}

std::string milliseconds (double time)
{
    return inWords (time * 1000) + " ms";
}

void addBrakeRemarks (FocusDesign& design, const Attempt& asked, const Attempt& taken, std::size_t modes)
{
    auto choice = "Brake: " + std::to_string (modes) + " modes are at rest " + milliseconds (taken.duration)
                  + " after the focus, velocity and displacement; ";

    if (! design.description.transients.brakeDuration)
        choice += "the time is chosen so that the slowest decays to a thousandth; ";

    if (taken.brake)
        choice += "each falls " + inWords (*taken.brake) + " times as fast as by itself.";
    else
        choice += taken.folds > 0 ? "all voltages fall together by 4 e-folds." : "the voltages do not fall until then.";

    design.choices.push_back (choice);

    if (taken.duration > asked.duration)
        design.warnings.push_back ("The voltage limit does not allow rest " + milliseconds (asked.duration)
                                   + " after the focus: it comes after " + milliseconds (taken.duration) + ".");
    else if (asked.brake && ! taken.brake)
        design.warnings.push_back ("The voltage limit does not allow so steep a brake: the motion decays more slowly "
                                   "at first, and is at rest at the same time.");
}
} // namespace

bool hasBrake (const TransientChoice& choice)
{
    return choice.brake.has_value() || choice.brakeDuration.has_value();
}

void appendBrake (FocusDesign& design, const ModalModel& model, const AllocationWatch& watch)
{
    const auto asked = attemptAsAsked (design, model);
    auto attempt = asked;
    auto problem = problemFor (design, model, attempt);
    auto allocation = allocate (problem, model, watch);

    while (allocation.certificate.status == AllocationStatus::infeasible && ! isEasiest (attempt))
    {
        attempt = easierThan (attempt, allocation.certificate.peakRatio);
        problem = problemFor (design, model, attempt);
        allocation = allocate (problem, model, watch);
    }

    addBrakeRemarks (design, asked, attempt, problem.modes.size());

    if (allocation.certificate.status == AllocationStatus::infeasible)
    {
        const auto share = 1 / allocation.certificate.peakRatio;
        allocation.matrix *= share;
        design.warnings.push_back ("The voltage limit allows only " + inWords (100 * share)
                                   + " % of the brake: the rest of the motion decays by itself.");
    }

    design.restTime = attempt.duration;
    addCounterShares (problem, model, allocation.matrix);
    append (design.program,
            programOf (problem.drives, allocation.matrix, design.program.voltageLimits, design.program.focusTime));
}
} // namespace antinode
