#include "FreeWaveform.h"

#include "DriveAllocation.h"
#include "FocusDesign.h"
#include "FreeSamples.h"
#include "LimitUse.h"
#include "QuietWaveform.h"
#include "WaveformProblem.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto largestGap = 1e-6; // beyond it the least energy was not found

AllocationCertificate makeCertificate (const PlayedWaveform& waveform, std::chrono::duration<double, std::milli> time)
{
    const auto& solution = waveform.free;
    AllocationCertificate certificate;
    certificate.peakRatio = waveform.peak;
    certificate.status = waveform.isLimited ? AllocationStatus::optimal : AllocationStatus::unconstrained;
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
} // namespace

FreeWaveform freeWaveform (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback playback)
{
    const auto start = std::chrono::steady_clock::now();
    const auto guards = guardModes (model, modes, description.allocation);
    const WaveformTask task { model, description, modes, guards, wanted, limits, playback };
    auto [solved, edgeTime] =
        hasSlewLimits (model) ? solveWithinSlews (task) : std::pair (solveWithEdges (task, 0), 0.0);
    auto& [problem, waveform] = solved;
    auto certificate = makeCertificate (waveform, std::chrono::steady_clock::now() - start);

    if (! (certificate.gap <= largestGap))
        throwTooNear (largestLimitField (task), limits.maxCoeff(), 1);

    FreeWaveform result { std::move (waveform.played), certificate, edgeTime, waveform.tolerantBound, {} };

    if (description.felt && description.allocation.isUpToLimits())
    {
        auto felt = modes;
        felt.insert (felt.end(), guards.begin(), guards.end());
        makeQuieter (result, { model, description, problem.all, felt, problem.sparse.range });
    }

    return result;
}

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

    if (task.description.allocation.isNearBound())
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
    const auto ratios = task.description.allocation.isNearBound()
                            ? sparseRatios (task.playback, highestFrequency (task))
                            : std::vector<SampleRatio> { {} };
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

namespace
{
/** How much of the slew limits a waveform uses. */
LimitUse slewOf (const WaveformTask& task, const SampledVoltages& voltages)
{
    VoltageProgram program;
    program.voltageLimits = task.limits;
    program.focusTime = task.description.focusTime;
    program.samples = voltages;
    return *limitUses (task.model, task.description.allocation, program).slew;
}

[[noreturn]] void throwTooSlow (const WaveformTask& task, const LimitUse& use)
{
    const auto peakVelocity = largestVelocity (task.description), reachable = peakVelocity / use.share();
    throw LimitError (limitField (use.kind),
                      "is " + limitAmount (use.kind, use.allowed) + ", too low for " + inWords (peakVelocity * 1000)
                          + " mm/s with free samples: " + limitedCeramic (task.model, use) + " needs "
                          + limitAmount (use.kind, use.used) + "; this limit allows " + inWords (reachable * 1000)
                          + " mm/s",
                      task.limits.maxCoeff(), reachable);
}

/** The time in which the slowest ceramic gets from 0 to its peak, s. */
double slowestRise (const Eigen::MatrixXd& values, const Eigen::VectorXd& slewLimits)
{
    double longest = 0;

    for (Eigen::Index i = 0; i < slewLimits.size(); ++i)
        if (slewLimits[i] > 0)
            longest = std::max (longest, values.row (i).cwiseAbs().maxCoeff() / slewLimits[i]);

    return longest;
}

/** The largest share of the slew limits around each free sample. N_b x N_s */
Eigen::MatrixXd slewShares (const SolvedWaveform& solved, const Eigen::VectorXd& slewLimits, double focusTime)
{
    const auto slopes = slopesOf (solved.waveform.played);
    const auto& sparse = solved.problem.sparse;
    const auto freeRate = sparse.freeRate();
    const auto columns = solved.problem.all.weights.cols();
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero (slewLimits.size(), columns);
    const auto interval = (slopes.last - slopes.first) / static_cast<double> (slopes.values.cols() - 1);

    for (Eigen::Index m = 0; m < slopes.values.cols(); ++m)
    {
        const auto before = focusTime - slopes.first - static_cast<double> (m) * interval;
        const auto n = sparse.range.focus - static_cast<Eigen::Index> (std::llround (std::abs (before) * freeRate));

        for (auto k = std::max<Eigen::Index> (n - 1, 0); k <= std::min (n + 1, columns - 1); ++k)
            for (Eigen::Index i = 0; i < slewLimits.size(); ++i)
                if (slewLimits[i] > 0)
                    shares (i, k) = std::max (shares (i, k), std::abs (slopes.values (i, m)) / slewLimits[i]);
    }

    return shares;
}

/** Lowers the free samples where what is played is too steep. */
void lowerWhereSteep (SolvedWaveform& solved, const Eigen::MatrixXd& steep, double room)
{
    constexpr double least = 0.02; // of the limit
    auto& all = solved.problem.all;

    if (all.shares.size() == 0)
        all.shares = Eigen::MatrixXd::Ones (steep.rows(), steep.cols());

    for (Eigen::Index n = 0; n < steep.cols(); ++n)
        for (Eigen::Index i = 0; i < steep.rows(); ++i)
            if (steep (i, n) > 1)
            {
                const auto used = std::abs (solved.waveform.free.samples (i, n)) / all.limits[i];
                all.shares (i, n) =
                    std::max (least * solved.waveform.peak, std::min (all.shares (i, n), used) / (room * steep (i, n)));
            }
}

/** Free samples are lowered where they are too steep, attempt by attempt. @return  none where that does not end */
std::optional<SolvedWaveform> solvedWithinSlews (const WaveformTask& task, const Eigen::VectorXd& slewLimits,
                                                 double edgeTime)
{
    constexpr int attempts = 20;
    constexpr double hopeless = 1.25, firstRoom = 1.01, moreRoom = 0.002;
    auto solved = solveWithEdges (task, edgeTime);
    const auto bound = solved.waveform.free.peakBound;
    auto best = std::numeric_limits<double>::infinity();

    for (int attempt = 0; attempt < attempts && solved.waveform.free.isMet; ++attempt)
    {
        solved.waveform.played = withSlowEnd (solved.waveform.played, slewLimits, task.description.focusTime);
        // Of waveforms with lowered samples the multipliers prove less.
        solved.waveform.free.peakBound = bound;

        const auto share = slewOf (task, solved.waveform.played).share();

        if (share <= 1)
            return solved;

        // The rows want steeper edges than these: lowered samples only make others steeper.
        if (share > hopeless * best)
            break;

        best = std::min (best, share);

        lowerWhereSteep (solved, slewShares (solved, slewLimits, task.description.focusTime),
                         firstRoom + moreRoom * attempt);
        solved.problem.all.start = solved.waveform.free.multipliers;
        solved.waveform = solvePlayed (solved.problem);
    }

    return {};
}
} // namespace

std::pair<SolvedWaveform, double> solveWithinSlews (const WaveformTask& task)
{
    constexpr double longer = 1.6, mostOfAll = 0.5; // of the time before the focus
    const auto slewLimits = antinode::slewLimits (task.model);
    auto free = solveWithEdges (task, 0);
    free.waveform.played = withSlowEnd (free.waveform.played, slewLimits, task.description.focusTime);
    const auto use = slewOf (task, free.waveform.played);

    if (use.share() <= 1)
        return { std::move (free), 0.0 };

    // Longer edges where shorter ones do not lead there.
    const auto sample = 1 / free.problem.sparse.freeRate();
    auto edge = std::max (slowestRise (free.waveform.played.values, slewLimits), sample);

    while (edge < mostOfAll * task.description.focusTime)
    {
        if (auto solved = solvedWithinSlews (task, slewLimits, edge))
            return { std::move (*solved), edge };

        edge *= longer;
    }

    throwTooSlow (task, use);
}
} // namespace antinode
