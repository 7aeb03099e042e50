#include "BrakeProblem.h"

#include "BrakeDrives.h"
#include "ComplexRows.h"
#include "Prediction.h"
#include "StateRows.h"
#include "Transients.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace antinode
{
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
