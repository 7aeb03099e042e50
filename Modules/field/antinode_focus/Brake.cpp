#include "Brake.h"

#include "ModeDrives.h"
#include "Prediction.h"
#include "StateRows.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

namespace
{
using namespace std::complex_literals;
using Complex = std::complex<double>;

constexpr double greatestCounterShare =
    0.9; // beyond, the brake lasts less than a cycle, so rotating it gives no other brake

std::vector<Oscillation> brakeDrive (int mode, double a, double b, const BrakeWindow& window, Complex phasor)
{
    auto drive = makeOnset (
        { mode, window.start, window.end - releaseDuration(), -window.decay, b, -phasor.imag(), phasor.real() });

    for (const auto& release : makeRelease (drive.front()))
        drive.push_back (release);

    for (auto& oscillation : drive)
        oscillation.freeDecay = a;

    return drive;
}
} // namespace

DriveList brakeDrives (int mode, double a, double b, const BrakeWindow& window)
{
    return { brakeDrive (mode, a, b, window, 1.0), brakeDrive (mode, a, b, window, -1i) };
}

Complex counterShare (Complex pole, const DriveList& drives, Complex force)
{
    return counterShare (pole, drives, force, std::conj (force));
}

Complex counterShare (Complex pole, const DriveList& drives, Complex force, Complex counterForce)
{
    const auto responseTo = [&] (const std::vector<Oscillation>& drive)
    {
        Complex state = 0;

        for (const auto& oscillation : drive)
            state += modalResponse (pole, oscillation, drive.back().end);

        return state;
    };
    const auto first = responseTo (drives[0]), second = 1i * responseTo (drives[1]);
    const auto with = force * (first + second), against = counterForce * (first - second);
    return std::abs (against) < greatestCounterShare * std::abs (with) ? against / with : 0.0;
}

namespace
{
constexpr double nothingLeft = 2e-5; // of the peak field: a mode that would add less by then is not braked

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
Eigen::VectorXd stackMotion (const Eigen::VectorXcd& states, const ModalModel& model, const std::vector<int>& modes)
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
        return stackMotion (predictStates (model, design.program, time), model, modes);

    DriveList single;

    for (const auto& oscillation : design.program.oscillations)
        single.push_back ({ oscillation });

    if (model.hasComplexModes())
        return complexRowValues (model, stateRows (time, modes), single, design.program.allocation, design.playback);

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
    const auto largestOf = [&] (Eigen::Index column) { return model.shapes.col (column).cwiseAbs().maxCoeff(); };
    const auto stillMoves = [&] (int k)
    {
        const auto shape =
            model.hasComplexModes() ? std::hypot (largestOf (k), largestOf (model.modes() + k)) : largestOf (k);
        const auto size = std::hypot (motion[k], motion[model.modes() + k]) * shape;
        return size > nothingLeft * design.reachablePeakVelocity;
    };
    std::copy_if (all.begin(), all.end(), std::back_inserter (others), [&] (int k) { return ! stillMoves (k); });
    std::erase_if (all, [&] (int k) { return ! stillMoves (k); });
    return { all, others };
}

DriveList drivesFor (const BrakeAttempt& attempt, const ModalModel& model, const std::vector<int>& modes, double focus)
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
} // namespace

BrakeProblem brakeProblem (const FocusDesign& design, const ModalModel& model, const BrakeAttempt& attempt)
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
    allocation.guardWeight = design.description.allocation.guardWeight;

    if (model.hasComplexModes())
    {
        addComplexRows (allocation, model, { stateRows (rest, modes), stateRows (rest, guards), {} }, problem.drives,
                        design.playback);
        return problem;
    }

    allocation.guardParticipation = stateParticipation (model, guards);
    allocation.guardRows = rowResponses (model, stateRows (rest, guards), problem.drives, design.playback);
    return problem;
}

void addCounterShares (BrakeProblem& problem, const ModalModel& model, const Eigen::MatrixXd& matrix)
{
    const auto poles = modalPoles (model);

    for (std::size_t i = 0; i < problem.modes.size(); ++i)
    {
        const auto k = problem.modes[i];
        const auto shares = matrix.middleCols (2 * static_cast<Eigen::Index> (i), 2);
        const Eigen::RowVectorXd forces = model.participation.row (k) * shares;
        std::complex<double> with (forces[0], -forces[1]), against = std::conj (with);

        if (model.hasComplexModes())
        {
            const Eigen::RowVectorXd turned = model.participation.row (model.modes() + k) * shares;
            with += std::complex<double> (turned[1], turned[0]);
            against += std::complex<double> (-turned[1], turned[0]);
        }

        const DriveList own { problem.drives[2 * i], problem.drives[2 * i + 1] };
        const auto share = counterShare (poles[k], own, with, against);

        for (auto drive = 2 * i; drive < 2 * i + 2; ++drive)
            for (auto& oscillation : problem.drives[drive])
                oscillation.counterShare = share;
    }
}
} // namespace antinode
