#include "WaveformTask.h"

#include "DriveAllocation.h"
#include "LimitError.h"
#include "LimitWords.h"
#include "SmoothEdges.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/** The least energy of the hard rows alone, without limits: what the guards' weight is measured with. */
double minimumEnergy (BoundedWaveformProblem problem)
{
    problem.limits.setConstant (std::numeric_limits<double>::infinity());
    problem.nearness = 0;
    return 2 * solveBoundedWaveform (problem).objective;
}

BoundedWaveformProblem withGuards (const BoundedWaveformProblem& hard, const Eigen::MatrixXd& weights,
                                   const Eigen::MatrixXd& participation, double weight)
{
    const auto stiffness = weight * minimumEnergy (hard) / hard.wanted.squaredNorm();

    if (! (stiffness > 0) || weights.rows() == 0)
        return hard;

    const auto rows = hard.wanted.size() + weights.rows();
    BoundedWaveformProblem all;
    all.weights.resize (rows, hard.weights.cols());
    all.weights << hard.weights, weights;
    all.participation.resize (rows, hard.participation.cols());
    all.participation << hard.participation, participation;
    all.wanted = Eigen::VectorXd::Zero (rows);
    all.wanted.head (hard.wanted.size()) = hard.wanted;
    all.compliance = Eigen::VectorXd::Zero (rows);
    all.compliance.tail (weights.rows()).setConstant (1 / stiffness);
    all.limits = hard.limits;
    all.costs = hard.costs;
    all.nearness = hard.nearness;
    return all;
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
    problem.weights = smoothEdgesAdjoint (problem.weights, edge);
}

/** @param edgeTime  s: time constant of the low-pass through which free samples are played; 0: none */
PlayedProblem makeProblem (const WaveformTask& task, Eigen::Index factor, double edgeTime)
{
    const auto& model = task.model;
    const auto rows = task.modes.size() + task.guards.size();
    const auto hardRowsOf = [&] (const SparseSamples& samples)
    { return hardRows (model, task.modes, task.wanted, task.limits, samples); };
    PlayedProblem problem;
    problem.sparse = sparseSamples (task.description, task.playback, rows, factor);
    problem.hard = hardRowsOf (problem.sparse);
    problem.focusTime = task.description.focusTime;

    if (task.isNearItsBound())
        problem.hard.nearness = task.description.allocation.timesBound.value_or (usualTimesBound);

    const auto edge = edgeTime * task.playback.sampleRate;
    problem.edge = edge / static_cast<double> (factor);

    if (factor > 1)
    {
        problem.everySample = hardRowsOf (sparseSamples (task.description, task.playback, rows, 1));
        smoothRows (*problem.everySample, edge);
    }

    problem.all = withGuards (problem.hard, velocityWeights (model, task.guards, problem.sparse),
                              model.participation (task.guards, Eigen::all), task.description.allocation.guardWeight);
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
    auto factor = task.isNearItsBound() ? largestFactor (task.playback, highestFrequency (task)) : 1;
    SolvedWaveform solved { makeProblem (task, factor, edgeTime), {} };
    solved.waveform = solvePlayed (solved.problem);

    // What sparse samples cannot reach, denser ones may.
    for (; ! solved.waveform.isNear && factor > 1; solved.waveform = solvePlayed (solved.problem))
        solved.problem = makeProblem (task, --factor, edgeTime);

    if (! solved.waveform.free.isMet)
        throwBeyondLimit (task, solved.problem.hard, edgeTime);

    return solved;
}
} // namespace antinode
