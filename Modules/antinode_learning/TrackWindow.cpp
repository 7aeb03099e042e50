#include "TrackWindow.h"

#include "AcquireSensor.h"
#include "LowerRate.h"
#include "ShiftedSignals.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr Eigen::Index mostTracked = 48; // modes
constexpr double longestDelay = 0.25;    // s
constexpr double edges = 0.03;           // s, that are lost where a recording is cut
constexpr int patience = 3;              // windows that are lost before the sensor is searched for again
constexpr double leastExplained = 0.6;   // of a signal, RMS, by the lowest modes
constexpr double noiseShare = 0.01;      // of the signal: 40 dB
constexpr double leastNoise = 3e-5;      // of full scale: one step of 16 bits
constexpr int mostDelaySteps = 4;
constexpr double smallestDelayStep = 5e-7; // s
constexpr double fullScale = 0.999;
constexpr double mostAtFullScale = 1e-3; // of the samples

FollowedDrift nothingNew (const TrackedDrift& drift, DriftState state, double unexplained, std::string reason)
{
    return { drift.estimate, state, unexplained, 0, std::move (reason) };
}

TrackedWindow lostWindow (TrackedDrift drift, double unexplained, std::string reason)
{
    ++drift.lost;
    auto followed = nothingNew (drift, DriftState::lost, unexplained, std::move (reason));
    return { std::move (drift), std::move (followed) };
}

/** Clipped samples also where no two are alike: behind an amplifier, or with noise on top. */
std::string faultOf (const PlayedRecording& recording)
{
    auto fault = signalFault (recording);

    if (! fault.empty() || ! recording.voltages.allFinite())
        return fault.empty() ? "The voltages are not finite." : fault;

    const auto atEnds = static_cast<double> ((recording.signals.array().abs() >= fullScale).count());
    return atEnds > mostAtFullScale * static_cast<double> (recording.signals.size()) ? "The sensor's signal is clipped."
                                                                                     : std::string();
}

double rootMeanSquare (const Eigen::MatrixXd& values)
{
    return values.norm() / std::sqrt (static_cast<double> (std::max<Eigen::Index> (1, values.size())));
}

/** The last samples. */
PlayedRecording newestOf (const PlayedRecording& recording, double seconds)
{
    const auto count =
        std::min (recording.voltages.cols(), static_cast<Eigen::Index> (std::ceil (seconds * recording.sampleRate)));
    return { recording.sampleRate, recording.voltages.rightCols (count), recording.signals.rightCols (count),
             recording.noise, recording.delay };
}

/** Below the highest tracked mode, as a rate: of what is differentiated the noise is, too. */
PlayedRecording prepared (const PlayedRecording& recording, const ModalModel& nominal, SensorQuantity quantity)
{
    auto result = atLowerRate (recording, highestModelled (nominal));

    if (quantity == SensorQuantity::rate)
        return result;

    const auto before = rootMeanSquare (result.signals);
    result.signals = slopesOf (result.signals, result.sampleRate).transpose().eval();
    result.noise *= rootMeanSquare (result.signals) / std::max (1e-30, before);
    return result;
}

DriftSettings withSensor (DriftSettings settings, const ModalModel& nominal, const TrackedSensor& sensor, double scale,
                          double delayDeviation)
{
    const Sensor scaled { scale * sensor.shapes, 0 };
    settings.spread.delay = delayDeviation;
    settings.spread.feedthrough = sensor.hearsVoltages ? usualFeedthrough (nominal, { scaled }) : 0;
    return settings;
}

/** The sensor as it was found, with all frequencies where it was found; none where too little is explained. */
AcquiredSensor search (const ModalModel& nominal, const TrackedSensor& sensor, const TrackedDrift& drift,
                       const PlayedRecording& recording, const DriftSettings& settings)
{
    const auto layout = driftLayout (nominal, 1);
    return acquireSensor (driftedModel (nominal, layout, drift.estimate.values), sensor.shapes, recording, settings,
                          longestDelay);
}

/** What is known of the device from now on, if the sensor is as it was found. */
TrackedDrift withAcquired (TrackedDrift drift, const ModalModel& nominal, const TrackedSensor& sensor,
                           const AcquiredSensor& found, const DriftSettings& settings)
{
    // Frequencies that are off by a part of a step look like a delay, the more the longer modes remember.
    constexpr double share = 0.25;
    const auto layout = driftLayout (nominal, 1);
    const Eigen::VectorXd decays = decayRates (nominal).head (modesForSearch (nominal));
    const auto deviation =
        share * jumpStep (nominal, settings) / median (std::vector<double> (decays.begin(), decays.end()));
    const auto known = withSensor (settings, nominal, sensor, found.scale, deviation);
    drift.estimate = afterJump (std::move (drift.estimate), layout, known.spread, found.jump,
                                std::max (jumpStep (nominal, settings), settings.spread.drift / 2));
    drift.estimate.values.tail (drift.estimate.values.size() - layout.gain (0, 0)).setZero();
    drift.delay = found.delay;
    drift.scale = found.scale;
    return drift;
}

/** A step with a sensor that is known. */
TrackedWindow followKnown (const ModalModel& nominal, const TrackedSensor& sensor, TrackedDrift drift,
                           PlayedRecording recording, const DriftSettings& settings)
{
    const auto layout = driftLayout (nominal, 1);
    const std::vector<Sensor> sensors { { drift.scale * sensor.shapes, 0 } };
    recording.delay = drift.delay;
    auto followed = followDrift (nominal, sensors, drift.estimate, recording,
                                 withSensor (settings, nominal, sensor, drift.scale, 0));

    if (followed.state == DriftState::lost)
        return lostWindow (std::move (drift), followed.unexplained, std::move (followed.reason));

    drift.lost = 0;

    if (followed.state == DriftState::following)
    {
        drift.delay = std::max (0.0, drift.delay + followed.estimate.values[layout.delay (0)]);
        followed.estimate.values[layout.delay (0)] = 0;
        drift.estimate = followed.estimate;
    }

    return { std::move (drift), std::move (followed) };
}
} // namespace

TrackedDrift startOfTracking (const DriftLayout& layout, const DriftSpread& spread)
{
    return { startOfDrift (layout, spread) };
}

ModalModel trackedModes (const ModalModel& model, double sampleRate)
{
    requireRealModes (model, "following a drift");
    const auto within = modesWithin (model, sampleRate);
    return firstModes (within, std::min (within.modes(), mostTracked));
}

double trackedLength (const DriftSettings& settings)
{
    return settings.memory + trackedWindow + longestDelay + edges;
}

double trackingMemory (const ModalModel& model)
{
    constexpr double left = 0.03, shortest = 0.1, longest = 0.5;
    return std::clamp (-std::log (left) / decayRates (model).minCoeff(), shortest, longest);
}

TrackedWindow trackWindow (const ModalModel& nominal, const TrackedSensor& sensor, const TrackedDrift& before,
                           PlayedRecording recording, const DriftSettings& settings)
{
    if (auto fault = faultOf (recording); ! fault.empty())
        return lostWindow (before, 1, std::move (fault));

    auto drift = before;
    const auto level = rootMeanSquare (recording.signals);

    if (! recording.voltages.any())
    {
        drift.quietest = drift.quietest > 0 ? std::min (drift.quietest, level) : level;
        auto followed = nothingNew (drift, DriftState::silent, 0, {});
        return { std::move (drift), std::move (followed) };
    }

    recording.noise = Eigen::VectorXd::Constant (1, std::max ({ noiseShare * level, leastNoise, drift.quietest }));
    const auto follow = [&] (TrackedDrift known)
    {
        const auto newest = newestOf (recording, settings.memory + trackedWindow + known.delay + edges);
        return followKnown (nominal, sensor, std::move (known), prepared (newest, nominal, sensor.quantity), settings);
    };

    if (drift.scale != 0 && drift.lost < patience)
        return follow (std::move (drift));

    const auto heard = prepared (recording, nominal, sensor.quantity);
    const auto found = search (nominal, sensor, drift, heard, settings);

    if (found.explained < leastExplained)
        return lostWindow (std::move (drift), 1 - found.explained,
                           "The sensor does not hear what is played, or something else.");

    auto known = withAcquired (drift, nominal, sensor, found, settings);
    auto result = follow (known);

    // A delay is linear only where it is small: from the one that was found the same window is followed once more.
    for (int i = 0; i < mostDelaySteps && result.followed.state == DriftState::following
                    && std::abs (result.drift.delay - known.delay) > smallestDelayStep;
         ++i)
    {
        known.delay = result.drift.delay;
        result = follow (known);
    }

    // A sensor that was found but does not lead anywhere is as unknown as before.
    if (result.followed.state == DriftState::following)
        return result;

    if (result.followed.state == DriftState::lost)
        return lostWindow (std::move (drift), result.followed.unexplained, std::move (result.followed.reason));

    return { drift, nothingNew (drift, DriftState::silent, 0, {}) };
}

Eigen::VectorXd frequencyChanges (const DriftEstimate& estimate, const DriftLayout& layout, Eigen::Index modes)
{
    const auto tracked = layout.modes;
    const Eigen::VectorXd values = estimate.values.head (tracked);
    const Eigen::VectorXd weights =
        estimate.factor.topRows (tracked).rowwise().squaredNorm().cwiseMax (1e-24).cwiseInverse();
    Eigen::VectorXd changes = Eigen::VectorXd::Constant (modes, weights.dot (values) / weights.sum());
    changes.head (std::min (modes, tracked)) = values.head (std::min (modes, tracked));
    return changes;
}

ModalModel retunedModel (const ModalModel& nominal, const DriftEstimate& estimate, const DriftLayout& layout)
{
    constexpr double largestDampingRatio = 0.9;
    const auto tracked = std::min (layout.modes, nominal.modes());
    auto model = nominal;
    model.angularFrequencies.array() *= frequencyChanges (estimate, layout, nominal.modes()).array().exp();
    model.dampingRatios.head (tracked) = (nominal.dampingRatios.head (tracked).array()
                                          * estimate.values.segment (layout.damping (0), tracked).array().exp())
                                             .min (largestDampingRatio);
    return model;
}
} // namespace antinode
