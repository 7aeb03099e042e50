#include "FreeWaveform.h"

#include "DriveAllocation.h"
#include "LimitError.h"
#include "LimitWords.h"
#include "PlayedWaveform.h"
#include "QuietWaveform.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr auto largestGap = 1e-6; // beyond it the least energy was not found

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

/** Where the largest of the limits is set. */
std::string largestLimitField (const ModalModel& model, const AllocationChoice& choice, const Eigen::VectorXd& limits)
{
    Eigen::Index largest = 0;
    limits.maxCoeff (&largest);
    return limitField (voltageLimitKind (model, choice, static_cast<std::size_t> (largest)));
}

/** Whether such a limit can be kept is not known, or it can and the search for the least energy did not end. */
[[noreturn]] void throwTooNear (const std::string& field, double limit, double minimumPeakRatio)
{
    constexpr auto room = 1.01;
    throw InputError (field, "is " + inWords (limit)
                                 + " V, too close to the lowest feasible voltage of any samples; allowed: at least "
                                 + inWords (room * std::max (1.0, minimumPeakRatio) * limit) + " V");
}

[[noreturn]] void throwBeyondLimit (const std::string& field, const BoundedWaveformProblem& hard,
                                    const FocusDescription& description)
{
    constexpr auto tolerance = 0.001;
    const auto bracket = minimumWaveformPeak (hard, tolerance);

    if (! std::isfinite (bracket.upper))
        throw InputError ("focus: controlled modes",
                          "cannot be controlled independently of each other; control fewer modes");

    if (bracket.upper <= 1)
        throwTooNear (field, hard.limits.maxCoeff(), bracket.upper);

    double peakVelocity = 0;

    for (const auto& target : description.targets)
        peakVelocity = std::max (peakVelocity, target.peakVelocity);

    const auto limit = hard.limits.maxCoeff();
    const auto reachable = peakVelocity / bracket.upper;
    throw LimitError (field,
                      "is " + inWords (limit) + " V, too low for " + inWords (peakVelocity * 1000)
                          + " mm/s: no sampled waveform reaches it below " + inWords (limit * bracket.lower)
                          + " V; this limit allows " + inWords (reachable * 1000) + " mm/s",
                      limit * bracket.upper, reachable);
}

AllocationCertificate makeCertificate (const PlayedWaveform& waveform, std::chrono::duration<double, std::milli> time)
{
    const auto& solution = waveform.free;
    AllocationCertificate certificate;
    certificate.peakRatio = waveform.peak;
    certificate.status =
        certificate.peakRatio < solution.limitShare ? AllocationStatus::unconstrained : AllocationStatus::optimal;
    certificate.iterations = solution.iterations;
    certificate.objective = solution.objective;
    certificate.bound = solution.bound;
    certificate.gap =
        solution.objective > 0 ? std::max (0.0, (solution.objective - solution.bound) / solution.objective) : 0;
    certificate.minimumPeakRatio = solution.peakBound;
    certificate.rowResidual = solution.rowResidual;
    certificate.milliseconds = time.count();
    return certificate;
}

/** What a free waveform is made for. */
struct WaveformTask
{
    const ModalModel& model;
    const FocusDescription& description;
    const std::vector<int>& modes;
    const std::vector<int>& guards;
    const Eigen::VectorXd& wanted;
    const Eigen::VectorXd& limits;
    Playback playback;

    bool isNearItsBound() const { return description.allocation.method == AllocationMethod::leastVoltage; }
};

PlayedProblem makeProblem (const WaveformTask& task, Eigen::Index factor)
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

    if (factor > 1)
        problem.everySample = hardRowsOf (sparseSamples (task.description, task.playback, rows, 1));

    problem.all = withGuards (problem.hard, velocityWeights (model, task.guards, problem.sparse),
                              model.participation (task.guards, Eigen::all), task.description.allocation.guardWeight);
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

FreeWaveform freeWaveform (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback playback)
{
    const auto start = std::chrono::steady_clock::now();
    const auto guards = guardModes (model, modes, description.allocation);
    const WaveformTask task { model, description, modes, guards, wanted, limits, playback };
    auto factor = task.isNearItsBound() ? largestFactor (playback, highestFrequency (task)) : 1;
    auto problem = makeProblem (task, factor);
    auto waveform = solvePlayed (problem);

    // What sparse samples cannot reach, denser ones may.
    for (; ! waveform.isNear && factor > 1; waveform = solvePlayed (problem))
        problem = makeProblem (task, --factor);

    if (! waveform.free.isMet)
        throwBeyondLimit (largestLimitField (model, description.allocation, limits), problem.hard, description);

    auto certificate = makeCertificate (waveform, std::chrono::steady_clock::now() - start);

    if (! (certificate.gap <= largestGap))
        throwTooNear (largestLimitField (model, description.allocation, limits), limits.maxCoeff(), 1);

    FreeWaveform result { std::move (waveform.played), certificate, {} };

    if (description.felt && description.allocation.method == AllocationMethod::freeWaveform)
    {
        auto felt = modes;
        felt.insert (felt.end(), guards.begin(), guards.end());
        makeQuieter (result, { model, description, problem.all, felt, problem.sparse.range });
    }

    return result;
}
} // namespace antinode
