#include "FreeWaveform.h"

#include "DriveAllocation.h"
#include "LimitError.h"
#include "LimitWords.h"
#include "QuietWaveform.h"
#include "SampleRange.h"

#include <antinode_allocation/BoundedWaveform.h>
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
                                 const Eigen::VectorXd& limits, Playback playback, const SampleRange& range)
{
    BoundedWaveformProblem problem;
    problem.weights = velocityWeights (model, modes, playback, range);
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

AllocationCertificate makeCertificate (const BoundedWaveform& solution, const Eigen::VectorXd& limits,
                                       std::chrono::duration<double, std::milli> time)
{
    AllocationCertificate certificate;
    certificate.peakRatio = solution.samples.cwiseAbs().rowwise().maxCoeff().cwiseQuotient (limits).maxCoeff();
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
} // namespace

FreeWaveform freeWaveform (const ModalModel& model, const FocusDescription& description, const std::vector<int>& modes,
                           const Eigen::VectorXd& wanted, const Eigen::VectorXd& limits, Playback playback)
{
    const auto start = std::chrono::steady_clock::now();
    const auto guards = guardModes (model, modes, description.allocation);
    const auto range = findSampleRange (description, playback, modes.size() + guards.size());
    auto hard = hardRows (model, modes, wanted, limits, playback, range);

    if (description.allocation.method == AllocationMethod::leastVoltage)
        hard.nearness = description.allocation.timesBound.value_or (usualTimesBound);

    const auto problem = withGuards (hard, velocityWeights (model, guards, playback, range),
                                     model.participation (guards, Eigen::all), description.allocation.guardWeight);
    const auto solution = solveBoundedWaveform (problem);
    const auto field = largestLimitField (model, description.allocation, limits);

    if (! solution.isMet)
        throwBeyondLimit (field, hard, description);

    auto certificate = makeCertificate (solution, limits, std::chrono::steady_clock::now() - start);

    if (! (certificate.gap <= largestGap))
        throwTooNear (field, limits.maxCoeff(), 1);

    const auto firstTime = description.focusTime - static_cast<double> (range.focus) / playback.sampleRate;
    FreeWaveform waveform { { playback, firstTime, withMirrorImage (solution.samples, range) }, certificate, {} };

    if (description.felt && description.allocation.method == AllocationMethod::freeWaveform)
    {
        auto rows = modes;
        rows.insert (rows.end(), guards.begin(), guards.end());
        makeQuieter (waveform, { model, description, problem, rows, range });
    }

    return waveform;
}
} // namespace antinode
