#include "WaveformTask.h"

#include "DriveAllocation.h"
#include "LimitError.h"
#include "LimitWords.h"
#include "SmoothEdges.h"
#include "TolerantSamples.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
BoundedWaveformProblem hardRows (const ModalModel& model, const std::vector<int>& modes, const Eigen::VectorXd& wanted,
                                 const Eigen::VectorXd& limits, const SparseSamples& sparse)
{
    const auto& range = sparse.range;
    BoundedWaveformProblem problem;
    problem.weights = velocityWeights (model, modes, sparse);
    problem.participation = model.participation (modes, Eigen::all);
    problem.wanted = wanted;
    problem.compliance = Eigen::VectorXd::Zero (wanted.size());
    problem.limits = limits;
    problem.costs = Eigen::VectorXd::Ones (range.count);

    // Of the focus sample only the half before the focus acts: at full cost it would be half as large as its
    // neighbours.
    if (range.mirrored > 0)
        problem.costs[range.focus] = 0.5;

    for (Eigen::Index k = 0; k < wanted.size(); ++k)
        if (wanted[k] != 0 && problem.participation.row (k).isZero (0))
            throw InputError ("device '" + model.name + "'",
                              "no ceramic excites controlled mode "
                                  + std::to_string (modes[static_cast<std::size_t> (k)] + 1)
                                  + "; leave this mode out, or place a ceramic where it bends");

    return problem;
}

BoundedWaveform withoutLimits (BoundedWaveformProblem problem)
{
    problem.limits.setConstant (std::numeric_limits<double>::infinity());
    problem.nearness = 0;
    return solveBoundedWaveform (problem);
}

/** What a squared row costs where as much as all that is wanted costs the least energy of the hard rows alone, without
    limits. */
double energyPrice (const BoundedWaveformProblem& hard)
{
    return 2 * withoutLimits (hard).objective / hard.wanted.squaredNorm();
}

/** Soft rows of modes that want to be at rest. @param stiffness  what their squares cost, twice */
BoundedWaveformProblem withGuards (const WaveformTask& task, const BoundedWaveformProblem& hard,
                                   const SparseSamples& sparse, double stiffness)
{
    const auto count = static_cast<Eigen::Index> (task.guards.size());

    if (! (stiffness > 0) || count == 0)
        return hard;

    const auto rows = hard.wanted.size() + count;
    auto all = hard;
    all.weights.conservativeResize (rows, Eigen::NoChange);
    all.weights.bottomRows (count) = velocityWeights (task.model, task.guards, sparse);
    all.participation.conservativeResize (rows, Eigen::NoChange);
    all.participation.bottomRows (count) = task.model.participation (task.guards, Eigen::all);
    all.wanted.conservativeResize (rows);
    all.wanted.tail (count).setZero();
    all.compliance.conservativeResize (rows);
    all.compliance.tail (count).setConstant (1 / stiffness);
    return all;
}

/** Guards, and what makes a waveform tolerant where that is asked for. @param price  as energyPrice says */
BoundedWaveformProblem withSoftRows (const WaveformTask& task, const BoundedWaveformProblem& hard,
                                     const SparseSamples& sparse, double price)
{
    const auto& choice = task.description.allocation;
    auto guarded = withGuards (task, hard, sparse, choice.guardWeight * price);

    if (! choice.robust || ! (choice.robust->weight * price > 0))
        return guarded;

    auto modes = task.modes;

    if (guarded.wanted.size() > hard.wanted.size())
        modes.insert (modes.end(), task.guards.begin(), task.guards.end());

    auto tolerant =
        withTolerance (guarded, { task.model, modes, sparse }, choice.robust->spread, choice.robust->weight * price);
    // Multipliers of the rows without these prove more of the hard ones, which limits near the bound begin with.
    tolerant.start.rows = Eigen::VectorXd::Zero (tolerant.wanted.size());
    tolerant.start.rows.head (guarded.wanted.size()) = withoutLimits (guarded).multipliers.rows;
    return tolerant;
}

/** "edges of 0.4 ms" where a slew limit asks for them. */
std::string withEdges (double edgeTime)
{
    return edgeTime > 0 ? " with edges of " + inWords (edgeTime * 1000) + " ms, as the slew limit asks for," : "";
}

[[noreturn]] void throwBeyondLimit (const WaveformTask& task, const BoundedWaveformProblem& hard, double edgeTime)
{
    constexpr auto tolerance = 0.001;
    const auto bracket = minimumWaveformPeak (hard, tolerance);

    if (! std::isfinite (bracket.upper))
        throw InputError ("focus: controlled modes",
                          "cannot be controlled independently of each other; control fewer modes");

    if (bracket.upper <= 1)
        throwTooNear (largestLimitField (task), hard.limits.maxCoeff(), bracket.upper);

    const auto peakVelocity = largestVelocity (task.description);
    const auto limit = hard.limits.maxCoeff();
    const auto reachable = peakVelocity / bracket.upper;
    throw LimitError (largestLimitField (task),
                      "is " + inWords (limit) + " V, too low for " + inWords (peakVelocity * 1000)
                          + " mm/s: no sampled waveform" + withEdges (edgeTime) + " reaches it below "
                          + inWords (limit * bracket.lower) + " V; this limit allows " + inWords (reachable * 1000)
                          + " mm/s",
                      limit * bracket.upper, reachable);
}

/** Rows for samples of which means are played. */
void smoothRows (BoundedWaveformProblem& problem, double edge)
{
    problem.weights = smoothEdgesAdjoint (std::move (problem.weights), edge);
}

/** @param edgeTime  s: time constant of the low-pass through which free samples are played; 0: none */
PlayedProblem makeProblem (const WaveformTask& task, SampleRatio ratio, double edgeTime)
{
    const auto rows = task.modes.size() + task.guards.size();
    const auto hardRowsOf = [&] (const SparseSamples& samples)
    { return hardRows (task.model, task.modes, task.wanted, task.limits, samples); };
    PlayedProblem problem;
    problem.sparse = sparseSamples (task.description, task.playback, rows, ratio);
    problem.hard = hardRowsOf (problem.sparse);
    problem.focusTime = task.description.focusTime;
    problem.isRobust = task.description.allocation.robust.has_value();

    if (task.isNearItsBound())
        problem.hard.nearness = task.description.allocation.timesBound.value_or (usualTimesBound);

    const auto edge = edgeTime * task.playback.sampleRate;
    problem.edge = edge / ratio.value();
    problem.all = withSoftRows (task, problem.hard, problem.sparse, energyPrice (problem.hard));

    if (! ratio.isOne())
    {
        problem.everySample = hardRowsOf (sparseSamples (task.description, task.playback, rows, {}));
        smoothRows (*problem.everySample, edge);
    }

    smoothRows (problem.hard, problem.edge);
    smoothRows (problem.all, problem.edge);
    return problem;
}

double highestFrequency (const WaveformTask& task)
{
    double highest = 0;

    for (const auto mode : task.modes)
        highest = std::max (highest, task.model.frequencyHz (mode));

    return highest;
}
} // namespace

std::string largestLimitField (const WaveformTask& task)
{
    Eigen::Index largest = 0;
    task.limits.maxCoeff (&largest);
    return limitField (voltageLimitKind (task.model, task.description.allocation, static_cast<std::size_t> (largest)));
}

double largestVelocity (const FocusDescription& description)
{
    double largest = 0;

    for (const auto& target : description.targets)
        largest = std::max (largest, target.peakVelocity);

    return largest;
}

void throwTooNear (const std::string& field, double limit, double minimumPeakRatio)
{
    constexpr auto room = 1.01;
    throw InputError (field, "is " + inWords (limit)
                                 + " V, too close to the lowest feasible voltage of any samples; allowed: at least "
                                 + inWords (room * std::max (1.0, minimumPeakRatio) * limit) + " V");
}

SolvedWaveform solveWithEdges (const WaveformTask& task, double edgeTime)
{
    const auto ratios =
        task.isNearItsBound() ? sparseRatios (task.playback, highestFrequency (task)) : std::vector<SampleRatio> { {} };
    SolvedWaveform solved;

    // What sparse samples cannot reach, denser ones may.
    for (const auto ratio : ratios)
    {
        solved.problem = makeProblem (task, ratio, edgeTime);
        solved.waveform = solvePlayed (solved.problem);

        if (solved.waveform.isNear)
            break;
    }

    if (! solved.waveform.free.isMet)
        throwBeyondLimit (task, solved.problem.hard, edgeTime);

    return solved;
}
} // namespace antinode
