#include "FollowDrift.h"

#include "DriftProblem.h"
#include "PlayedRecording.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussNewton.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double percent = 100;
constexpr double mostUnexplainedShare = 0.3; // of the signals, RMS
constexpr double leastHeard = 100;           // energy over the noise's: less is no information
constexpr double mostClipped = 1e-3;         // of the samples, at the largest value
constexpr int mostFitSteps = 6;

/** The most probable values in units of what was known before: values = before + factor z. */
struct Fit
{
    DriftEstimate estimate;
    double misfit = 0;
};

/** What the data say of the values in units of what was known before, R z: I + R' G R, lower triangle, and R' g - z. */
SumOfSquares::Equations whitened (const DriftProblem::Equations& equations, const Eigen::MatrixXd& factor,
                                  const Eigen::VectorXd& z, double noise)
{
    const Eigen::MatrixXd rows = factor (equations.parameters, Eigen::all);
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero (rows.rows(), rows.cols());
    addProduct (product, 1 / noise, equations.matrix, rows);
    SumOfSquares::Equations result { Eigen::MatrixXd::Identity (rows.cols(), rows.cols()),
                                     rows.transpose() * equations.right / noise - z,
                                     equations.misfit / noise + z.squaredNorm() };
    addTransposedLeft (result.matrix, 1, rows, product);
    return result;
}

/** @param noise  how many noises each residual stands for */
Fit fitted (const DriftProblem& problem, const DriftEstimate& before, double noise)
{
    const auto valuesAt = [&] (const Eigen::VectorXd& z) -> Eigen::VectorXd
    { return before.values + before.factor * z; };
    const SumOfSquares squares { [&] (const Eigen::VectorXd& z)
                                 { return whitened (problem.equations (valuesAt (z)), before.factor, z, noise); },
                                 [&] (const Eigen::VectorXd& z)
                                 { return problem.misfit (valuesAt (z)) / noise + z.squaredNorm(); } };
    GaussNewtonSettings settings;
    settings.mostSteps = mostFitSteps;
    settings.bounds.setConstant (before.values.size(), std::numeric_limits<double>::infinity());
    settings.stepLimits = settings.bounds;
    const auto found = smallestSum (squares, Eigen::VectorXd::Zero (before.values.size()), settings);
    Fit fit { { valuesAt (found.values), before.factor }, (found.sum - found.values.squaredNorm()) * noise };
    // The covariance is that of the last values but a step that hardly moved.
    solveLowerTransposedFromRight (found.factored, fit.estimate.factor);
    return fit;
}

/** The fit, with what it does not explain as noise. */
Fit fittedWithMisfit (const DriftProblem& problem, const DriftEstimate& before)
{
    const auto first = fitted (problem, before, 1);
    const auto noise = problem.residualNoise (first.estimate.values);
    return noise > 1 ? fitted (problem, before, noise) : first;
}

/** RMS of what is not explained beyond the noise, of the signals without theirs. */
double unexplainedShare (const DriftProblem& problem, double misfit)
{
    const auto signal = std::max (problem.signalEnergy() - problem.samples(), problem.samples() / percent);
    return std::sqrt (std::max (0.0, misfit - problem.samples()) / signal);
}

/** The factor of all frequencies near the estimate's that explains most: its logarithm. It is the same for all modes,
    so the lowest ones tell it, at a low rate. */
double bestJump (const DriftEstimate& before, const ModalModel& nominal, const std::vector<Sensor>& sensors,
                 const PlayedRecording& recording, const DriftSettings& settings, double step)
{
    const auto count = modesForSearch (nominal);
    const auto model = firstModes (nominal, count);
    const DriftLayout layout { nominal.modes(), static_cast<Eigen::Index> (sensors.size()), nominal.actuators() };
    const auto few = estimateOfFirst (before, layout, nominal, sensors, count);
    auto fewSensors = sensors;

    for (auto& sensor : fewSensors)
        sensor.shapes.conservativeResize (count);

    DriftProblem problem (model, fewSensors, atLowerRate (recording, highestModelled (model)), settings.memory);
    problem.choose (few);
    const auto steps = std::lround (settings.largestJump / step);
    double best = 0, least = problem.misfit (few.values);

    for (auto i = -steps; i <= steps; ++i)
    {
        auto values = few.values;
        values.head (count).array() += static_cast<double> (i) * step;

        if (const auto misfit = problem.misfit (values); misfit < least)
        {
            least = misfit;
            best = static_cast<double> (i) * step;
        }
    }

    return best;
}

/** Whether the parameters that were heard have moved no farther than chance lets them, on the whole: single weak modes
    may, beside loud ones that are not quite as modelled. */
bool isPlausible (const DriftEstimate& before, const DriftEstimate& after)
{
    constexpr double heard = 0.7;  // of the deviation before: the parameter was heard where less is left
    constexpr double farthest = 5; // standard deviations, RMS
    double squares = 0, count = 0;

    for (Eigen::Index p = 0; p < before.values.size(); ++p)
        if (const auto deviation = before.deviation (p); after.deviation (p) < heard * deviation)
        {
            squares += std::pow ((after.values[p] - before.values[p]) / deviation, 2);
            ++count;
        }

    return squares <= farthest * farthest * count;
}

/** A fit that can be judged. */
struct Attempt
{
    DriftEstimate estimate;
    double unexplained = 0, jump = 0;
    bool isTaken = false; ///< Explains enough, by values that are plausible.
};

Attempt attempted (const DriftProblem& problem, const DriftEstimate& before, double jump)
{
    auto fit = fittedWithMisfit (problem, before);
    const auto unexplained = unexplainedShare (problem, fit.misfit);
    const auto isTaken = unexplained < mostUnexplainedShare && isPlausible (before, fit.estimate);
    return { std::move (fit.estimate), unexplained, jump, isTaken };
}

/** From the common shift of all frequencies that explains most. */
Attempt attemptedAfterJump (DriftProblem& problem, const DriftEstimate& before, const ModalModel& nominal,
                            const std::vector<Sensor>& sensors, const PlayedRecording& recording,
                            const DriftSettings& settings)
{
    const auto step = jumpStep (nominal, settings);
    const auto jump = bestJump (before, nominal, sensors, recording, settings, step);
    const auto after = afterJump (before, problem.layout(), settings.spread, jump, step);
    problem.choose (after);
    return attempted (problem, after, std::expm1 (jump));
}

FollowedDrift lost (const DriftEstimate& before, double unexplained, std::string reason)
{
    return { before, DriftState::lost, unexplained, 0, std::move (reason) };
}

FollowedDrift followed (Attempt attempt)
{
    return { std::move (attempt.estimate), DriftState::following, attempt.unexplained, attempt.jump, {} };
}
} // namespace

double jumpStep (const ModalModel& nominal, const DriftSettings& settings)
{
    const auto& ratios = nominal.dampingRatios;
    const auto usual = median (std::vector<double> (ratios.begin(), ratios.end()));
    // Half of the usual half width of a resonance: a step lands within the reach of the fit.
    return std::clamp (usual / 2, settings.largestJump / 40, settings.largestJump / 4);
}

Eigen::Index modesForSearch (const ModalModel& model)
{
    constexpr Eigen::Index fewest = 6, most = 16;
    return std::min (model.modes(), std::clamp (model.modes() / 2, fewest, most));
}

std::string signalFault (const PlayedRecording& recording)
{
    if (! recording.signals.allFinite())
        return "The sensor's signal is not finite.";

    for (Eigen::Index m = 0; m < recording.signals.rows(); ++m)
    {
        const auto row = recording.signals.row (m).array();
        const auto largest = row.abs().maxCoeff();
        const auto atLargest = static_cast<double> ((row.abs() >= largest).count());

        if (largest > 0 && atLargest > std::max (2.0, mostClipped * static_cast<double> (row.size())))
            return "The sensor's signal is clipped.";
    }

    return {};
}

FollowedDrift followDrift (const ModalModel& nominal, const std::vector<Sensor>& sensors, const DriftEstimate& before,
                           const PlayedRecording& recording, const DriftSettings& settings)
{
    constexpr double clearlyBetter = 0.9;

    if (auto reason = signalFault (recording); ! reason.empty())
        return lost (before, 1, std::move (reason));

    DriftProblem problem (nominal, sensors, recording, settings.memory);
    problem.choose (before);
    const auto heard = problem.heardEnergy (before.values);

    if (heard < leastHeard)
        return { before, DriftState::silent, 0, 0, {} };

    if (problem.signalEnergy() < 2 * problem.samples() && heard > 8 * problem.samples())
        return lost (before, 1, "The sensor does not hear what is played.");

    const auto surprise = unexplainedShare (problem, problem.misfit (before.values));
    auto near = attempted (problem, before, 0);

    if (near.isTaken && surprise < mostUnexplainedShare)
        return followed (std::move (near));

    // After a jump the fit may end beside it, with wrong dampings and gains: the search has to agree.
    auto far = attemptedAfterJump (problem, before, nominal, sensors, recording, settings);

    if (near.isTaken && ! (far.isTaken && far.unexplained < clearlyBetter * near.unexplained))
        return followed (std::move (near));

    if (far.isTaken)
        return followed (std::move (far));

    const auto left = std::min (near.unexplained, far.unexplained);

    if (left < mostUnexplainedShare)
        return lost (before, left, "Only a device that is far from the model explains the sensor's signal.");

    return lost (before, left,
                 "The model does not explain " + inWords (percent * left) + " % of the sensor's signal; allowed: below "
                     + inWords (percent * mostUnexplainedShare) + " %.");
}

namespace
{
/** A window of a recording with what was played before it, and what it answers later. */
PlayedRecording cut (const PlayedRecording& recording, Eigen::Index first, Eigen::Index count)
{
    return { recording.sampleRate, recording.voltages.middleCols (first, count),
             recording.signals.middleCols (first, count), recording.noise, recording.delay };
}
} // namespace

DriftMoment momentOf (const FollowedDrift& followed, const DriftLayout& layout, double time)
{
    const auto modes = layout.modes;
    DriftMoment moment;
    moment.time = time;
    moment.state = followed.state;
    moment.unexplained = followed.unexplained;
    moment.jump = followed.jump;
    moment.reason = followed.reason;
    moment.frequencies = followed.estimate.values.head (modes).array().exp() - 1;
    moment.deviations = followed.estimate.factor.topRows (modes).rowwise().norm();
    const Eigen::ArrayXd weights = moment.deviations.array().max (1e-12).square().inverse();
    moment.common = (weights * moment.frequencies.array()).sum() / weights.sum();
    return moment;
}

DriftTrace followRecording (const ModalModel& nominal, const std::vector<Sensor>& sensors, const PlayedRecording& whole,
                            const DriftSettings& settings, double window, const std::function<void (double)>& progress)
{
    constexpr double edge = 256; // samples that are lost where a signal is cut
    const auto recording = atLowerRate (whole, highestModelled (nominal));
    const auto rate = recording.sampleRate;
    const auto step = static_cast<Eigen::Index> (std::ceil (window * rate));
    const auto length =
        step + static_cast<Eigen::Index> (std::ceil ((settings.memory + recording.delay) * rate) + edge);

    if (! (window > 0) || recording.voltages.cols() < length)
        throw InputError ("recording", "has " + inWords (static_cast<double> (recording.voltages.cols()) / rate)
                                           + " s; allowed: at least " + inWords (static_cast<double> (length) / rate)
                                           + " s");

    const auto layout = driftLayout (nominal, static_cast<Eigen::Index> (sensors.size()));
    DriftTrace trace { {}, startOfDrift (layout, settings.spread) };
    const auto last = recording.voltages.cols() - length;

    for (Eigen::Index first = 0; first <= last; first += step)
    {
        auto followed = followDrift (nominal, sensors, trace.estimate, cut (recording, first, length), settings);
        trace.moments.push_back (momentOf (followed, layout, static_cast<double> (first + length) / rate));
        trace.estimate = afterTime (std::move (followed.estimate), layout, settings.spread, window);

        if (progress)
            progress (static_cast<double> (first + step) / static_cast<double> (last + step));
    }

    return trace;
}
} // namespace antinode
