#include "DriftProblem.h"

#include "LearningEquations.h"
#include "PlayedRecording.h"

#include <Eigen/QR>
#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace antinode
{
namespace
{
constexpr double leastLeft = 1e-3; // of a motion, after the memory
constexpr std::size_t mostSlow = 24;

/** The slowest modes that still ring after a time. */
std::vector<Eigen::Index> slowModes (const Eigen::VectorXd& decays, double memory)
{
    std::vector<Eigen::Index> slow;

    for (Eigen::Index k = 0; k < decays.size(); ++k)
        if (std::exp (-decays[k] * memory) > leastLeft)
            slow.push_back (k);

    std::sort (slow.begin(), slow.end(), [&] (auto one, auto other) { return decays[one] < decays[other]; });
    slow.resize (std::min (slow.size(), mostSlow));
    return slow;
}
} // namespace

RingingBefore::RingingBefore (const ModalModel& modes, double sampleRate, double memory, Eigen::Index samples)
{
    const Eigen::VectorXd decays = decayRates (modes);
    const auto slow = slowModes (decays, memory);
    const auto columns = 2 * static_cast<Eigen::Index> (slow.size());

    if (columns == 0 || columns >= samples)
        return;

    Eigen::MatrixXd rings (samples, columns);

    for (std::size_t j = 0; j < slow.size(); ++j)
    {
        const auto decay = decays[slow[j]], natural = modes.angularFrequencies[slow[j]];
        const auto turning = std::sqrt (std::max (0.0, natural * natural - decay * decay));
        const auto turn = std::exp (std::complex<double> (-decay, turning) / sampleRate);
        std::complex<double> ring = 1;

        for (Eigen::Index n = 0; n < samples; ++n, ring *= turn)
        {
            rings (n, 2 * static_cast<Eigen::Index> (j)) = ring.real();
            rings (n, 2 * static_cast<Eigen::Index> (j) + 1) = ring.imag();
        }
    }

    basis = Eigen::HouseholderQR<Eigen::MatrixXd> (rings).householderQ() * Eigen::MatrixXd::Identity (samples, columns);
}

void RingingBefore::takeOutOf (Eigen::Ref<Eigen::MatrixXd> signals) const
{
    if (basis.size() > 0)
        signals -= basis * (basis.transpose() * signals);
}

namespace
{
void requireRecording (bool isRight, const std::string& what)
{
    if (! isRight)
        throw InputError ("recording", what);
}

void checkRecording (const ModalModel& model, const std::vector<Sensor>& sensors, const PlayedRecording& recording)
{
    requireRealModes (model, "following a drift");
    requireRecording (! sensors.empty(), "needs at least one sensor");

    for (const auto& sensor : sensors)
        requireRecording (sensor.shapes.size() == model.modes() && sensor.shapes.allFinite(),
                          "needs one finite shape of every mode for every sensor");

    requireRecording (recording.voltages.rows() == model.actuators() && recording.voltages.allFinite(),
                      "needs finite voltages of all " + std::to_string (model.actuators()) + " ceramics");
    requireRecording (recording.signals.rows() == static_cast<Eigen::Index> (sensors.size())
                          && recording.signals.cols() == recording.voltages.cols() && recording.signals.allFinite(),
                      "needs a finite signal of every sensor, as long as the voltages");
    requireRecording (recording.noise.size() == recording.signals.rows() && recording.noise.minCoeff() > 0
                          && recording.sampleRate > 0 && recording.delay >= 0,
                      "needs noise above 0, a sample rate above 0 and a delay of 0 or more");
}

constexpr double leastDelay = 2e-7;          // s, of a deviation
constexpr Eigen::Index mostForces = 1 << 23; // numbers that are kept: 64 MB
} // namespace

DriftProblem::DriftProblem (const ModalModel& model, const std::vector<Sensor>& sensorsToHear,
                            const PlayedRecording& recording, double memory)
    : nominal (model), order (driftLayout (model, static_cast<Eigen::Index> (sensorsToHear.size()))),
      voltages ((checkRecording (model, sensorsToHear, recording), recording.voltages), recording.sampleRate)
{
    const auto last = comparableSamples (recording);
    first = static_cast<Eigen::Index> (std::ceil (std::max (0.0, memory) * recording.sampleRate));
    requireRecording (first < last, "is too short: nothing is left to compare after the memory of the modes");

    const Eigen::VectorXd precision = recording.noise.cwiseInverse();
    const Eigen::MatrixXd all = signalsEarlier (recording, recording.delay, recording.signals.cols());
    signals = all.middleRows (first, last - first) * precision.asDiagonal();
    energy = signals.squaredNorm();
    slopes = slopesOf (recording.voltages, recording.sampleRate).middleRows (first, last - first);
    // Of all there is: the slope of a signal that is cut rings at the cut.
    signalSlopes =
        slopesOf (all.transpose(), recording.sampleRate).middleRows (first, last - first) * precision.asDiagonal();

    if (PlayedVoltages::places * voltages.samples() * order.modes <= mostForces)
        forces = voltages.forces (nominal.participation);

    weights.resize (order.sensors, order.modes);

    for (Eigen::Index m = 0; m < order.sensors; ++m)
        weights.row (m) = precision[m] * sensorsToHear[static_cast<std::size_t> (m)].shapes;

    feedthroughWeights = precision;
}

void DriftProblem::choose (const DriftEstimate& estimate)
{
    constexpr double leastInformation = 0.01; // of what was known before, of a parameter
    const auto modes = driftedModel (nominal, order, estimate.values);
    const auto square = [&] (Eigen::Index parameter) { return estimate.factor.row (parameter).squaredNorm(); };
    std::vector<Eigen::VectorXd> velocities (static_cast<std::size_t> (order.modes));
    std::vector<char> isHeard (velocities.size());
    parallelFor (velocities.size(),
                 [&] (std::size_t mode)
                 {
                     const auto k = static_cast<Eigen::Index> (mode);
                     const auto motion = motionOf (modes, k, true);
                     velocities[mode] = compared (motion.velocity);
                     const auto said =
                         weights.col (k).squaredNorm()
                         * std::max ({ compared (motion.byFrequency).squaredNorm() * square (order.frequency (k)),
                                       compared (motion.byDamping).squaredNorm() * square (order.damping (k)),
                                       velocities[mode].squaredNorm() * square (order.gain (0, k)) });
                     isHeard[mode] = said > leastInformation;
                 });
    followed.clear();
    others = Eigen::MatrixXd::Zero (signals.rows(), order.sensors);

    for (Eigen::Index k = 0; k < order.modes; ++k)
        if (const auto mode = static_cast<std::size_t> (k); isHeard[mode])
            followed.push_back (k);
        else
            others += velocities[mode] * weights.col (k).transpose();

    const auto isAnyIn = [&] (Eigen::Index from, Eigen::Index count)
    { return (estimate.values.segment (from, count).array() != 0).any() || square (from) > 0; };
    hasFeedthrough = isAnyIn (order.feedthrough (0, 0), order.sensors * order.ceramics);
    // Of a delay that is known the covariance has rounding only.
    hasDelay = estimate.values.tail (order.sensors).any() || square (order.delay (0)) > leastDelay * leastDelay;
}

ModeMotion DriftProblem::motionOf (const ModalModel& modes, Eigen::Index k, bool withChanges) const
{
    const auto motion = [&] (const Eigen::VectorXd& force)
    {
        return modeMotion (modes.angularFrequencies[k], modes.dampingRatios[k], force, voltages.sampleRate(),
                           first + signals.rows(), withChanges);
    };
    return forces.size() > 0 ? motion (forces.col (k)) : motion (voltages.force (modes.participation.row (k)));
}

DriftProblem::Prediction DriftProblem::predict (const Eigen::VectorXd& values, bool withChanges) const
{
    checkWatch();
    const auto modes = driftedModel (nominal, order, values);
    Prediction prediction { others, std::vector<ModeMotion> (followed.size()),
                            RingingBefore (modes, voltages.sampleRate(),
                                           static_cast<double> (first) / voltages.sampleRate(), signals.rows()) };
    parallelFor (followed.size(),
                 [&] (std::size_t j) { prediction.motions[j] = motionOf (modes, followed[j], withChanges); });

    for (Eigen::Index m = 0; m < order.sensors; ++m)
    {
        for (std::size_t j = 0; j < followed.size(); ++j)
            prediction.signals.col (m) += gainOf (values, m, followed[j]) * compared (prediction.motions[j].velocity);

        if (hasFeedthrough)
            prediction.signals.col (m) +=
                feedthroughWeights[m] * (slopes * values.segment (order.feedthrough (m, 0), order.ceramics));

        // What comes later by a little: the signals' own slope is known.
        if (hasDelay)
            prediction.signals.col (m) -= values[order.delay (m)] * signalSlopes.col (m);
    }

    return prediction;
}

Eigen::MatrixXd DriftProblem::residualOf (const Prediction& prediction) const
{
    Eigen::MatrixXd residual = signals - prediction.signals;
    prediction.ringing.takeOutOf (residual);
    return residual;
}

DriftProblem::Equations DriftProblem::equations (const Eigen::VectorXd& values) const
{
    const auto prediction = predict (values, true);
    const auto count = static_cast<Eigen::Index> (followed.size());
    const auto ceramics = hasFeedthrough ? order.ceramics : 0;
    const Eigen::Index delays = hasDelay ? 1 : 0;
    const auto perSensor = count + ceramics + delays;
    Equations result;

    for (const auto k : followed)
        result.parameters.push_back (order.frequency (k));

    for (const auto k : followed)
        result.parameters.push_back (order.damping (k));

    for (Eigen::Index m = 0; m < order.sensors; ++m)
    {
        for (const auto k : followed)
            result.parameters.push_back (order.gain (m, k));

        for (Eigen::Index i = 0; i < ceramics; ++i)
            result.parameters.push_back (order.feedthrough (m, i));

        if (hasDelay)
            result.parameters.push_back (order.delay (m));
    }

    const auto all = static_cast<Eigen::Index> (result.parameters.size());
    result.matrix = Eigen::MatrixXd::Zero (all, all);
    result.right = Eigen::VectorXd::Zero (all);
    const auto residual = residualOf (prediction);
    result.misfit = residual.squaredNorm();

    for (Eigen::Index m = 0; m < order.sensors; ++m)
    {
        // What this sensor hears of all modes' changes, and of what only it hears: two ranges of the parameters.
        Eigen::MatrixXd changes (signals.rows(), 2 * count + perSensor);

        for (Eigen::Index j = 0; j < count; ++j)
        {
            const auto& motion = prediction.motions[static_cast<std::size_t> (j)];
            const auto k = followed[static_cast<std::size_t> (j)];
            const auto gain = gainOf (values, m, k);
            changes.col (j) = gain * compared (motion.byFrequency);
            changes.col (count + j) = gain * compared (motion.byDamping);
            changes.col (2 * count + j) = weights (m, k) * compared (motion.velocity);
        }

        if (ceramics > 0)
            changes.middleCols (3 * count, ceramics) = feedthroughWeights[m] * slopes;

        if (hasDelay)
            changes.rightCols (1) = -signalSlopes.col (m);

        prediction.ringing.takeOutOf (changes);
        Eigen::VectorXi at = Eigen::VectorXi::LinSpaced (changes.cols(), 0, static_cast<int> (changes.cols()) - 1);
        at.tail (perSensor).array() += static_cast<int> (m * perSensor);
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (changes.cols(), changes.cols());
        addGram (gram, 1, changes.transpose());
        gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
        result.matrix (at, at) += gram;
        result.right (at) += changes.transpose() * residual.col (m);
    }

    return result;
}

double DriftProblem::misfit (const Eigen::VectorXd& values) const
{
    return residualOf (predict (values, false)).squaredNorm();
}

double DriftProblem::heardEnergy (const Eigen::VectorXd& values) const
{
    return predict (values, false).signals.squaredNorm();
}

double DriftProblem::residualNoise (const Eigen::VectorXd& values) const
{
    const auto residual = residualOf (predict (values, false));
    double largest = 1;

    for (Eigen::Index m = 0; m < residual.cols(); ++m)
        largest = std::max (largest, powerAsWhiteNoise (residual.col (m)));

    return largest;
}
} // namespace antinode
