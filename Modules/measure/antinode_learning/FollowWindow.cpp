#include "FollowWindow.h"

#include "AcquireSensor.h"
#include "LowerRate.h"
#include "ShiftedSignals.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr Eigen::Index mostFollowed = 48; // modes
constexpr double longestDelay = 0.25;     // s
constexpr double edges = 0.03;            // s, that are lost where a recording is cut
constexpr int patience = 3;               // windows that are lost before the sensor is searched for again
constexpr double leastExplained = 0.6;    // of a signal, RMS, by the lowest modes
constexpr double noiseShare = 0.01;       // of the signal: 40 dB
constexpr double leastNoise = 3e-5;       // of full scale: one step of 16 bits
constexpr int mostDelaySteps = 4;
constexpr double smallestDelayStep = 5e-7; // s
constexpr double fullScale = 0.999;
constexpr double mostAtFullScale = 1e-3; // of the samples

FollowedDrift nothingNew (const SensedDrift& drift, DriftState state, double unexplained, std::string reason)
{
    return { drift.estimate, state, unexplained, 0, std::move (reason) };
}

FollowedWindow lostWindow (SensedDrift drift, double unexplained, std::string reason)
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

/** Below the highest followed mode, as a rate: of what is differentiated the noise is, too. */
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

DriftSettings withSensor (DriftSettings settings, const ModalModel& nominal, const DriftSensor& sensor, double scale,
                          double delayDeviation)
{
    const Sensor scaled { scale * sensor.shapes };
    settings.spread.delay = delayDeviation;
    settings.spread.feedthrough = sensor.hearsVoltages ? usualFeedthrough (nominal, { scaled }) : 0;
    return settings;
}

/** A window: of which device, by which sensor. */
struct Heard
{
    const ModalModel& nominal;
    const DriftSensor& sensor;
    const PlayedRecording& recording;
    const DriftSettings& settings;
};

/** The sensors that may be, with all frequencies where they were found. */
std::vector<AcquiredSensor> search (const Heard& heard, const SensedDrift& drift)
{
    const auto layout = driftLayout (heard.nominal, 1);
    return likelySensors (driftedModel (heard.nominal, layout, drift.estimate.values), heard.sensor.shapes,
                          prepared (heard.recording, heard.nominal, heard.sensor.quantity), heard.settings,
                          longestDelay);
}

/** What is known of the device from now on, if the sensor is as it was found. */
SensedDrift withAcquired (SensedDrift drift, const ModalModel& nominal, const DriftSensor& sensor,
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
FollowedWindow followKnown (const ModalModel& nominal, const DriftSensor& sensor, SensedDrift drift,
                            PlayedRecording recording, const DriftSettings& settings)
{
    const auto layout = driftLayout (nominal, 1);
    const std::vector<Sensor> sensors { { drift.scale * sensor.shapes } };
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
/** A step with the newest part of the recording. */
FollowedWindow followNewest (const Heard& heard, SensedDrift drift)
{
    const auto newest = newestOf (heard.recording, heard.settings.memory + followedWindow + drift.delay + edges);
    return followKnown (heard.nominal, heard.sensor, std::move (drift),
                        prepared (newest, heard.nominal, heard.sensor.quantity), heard.settings);
}

/** A step from one of several sensors: the one that leaves least unexplained counts, whatever the lowest modes alone
   say. A delay is linear only where it is small: from the one that was found the same window is followed once more. */
FollowedWindow followLikeliest (const Heard& heard, const std::vector<SensedDrift>& likely)
{
    const auto isBetter = [] (const FollowedWindow& a, const FollowedWindow& b) {
        return std::pair (a.followed.state, a.followed.unexplained)
               < std::pair (b.followed.state, b.followed.unexplained);
    };
    auto known = likely.front();
    auto result = followNewest (heard, known);

    for (auto other = likely.begin() + 1; other != likely.end(); ++other)
        if (auto window = followNewest (heard, *other); isBetter (window, result))
        {
            known = *other;
            result = std::move (window);
        }

    for (int i = 0; i < mostDelaySteps && result.followed.state == DriftState::following
                    && std::abs (result.drift.delay - known.delay) > smallestDelayStep;
         ++i)
    {
        known.delay = result.drift.delay;
        result = followNewest (heard, known);
    }

    return result;
}

/** A step with a sensor that has to be found first. */
FollowedWindow acquire (const Heard& heard, SensedDrift drift)
{
    const auto found = search (heard, drift);
    const auto explained = found.empty() ? 0 : found.front().explained;

    if (explained < leastExplained)
        return lostWindow (std::move (drift), 1 - explained,
                           "The sensor does not hear what is played, or something else.");

    std::vector<SensedDrift> likely;
    likely.reserve (found.size());

    for (const auto& one : found)
        likely.push_back (withAcquired (drift, heard.nominal, heard.sensor, one, heard.settings));

    auto result = followLikeliest (heard, likely);

    // A sensor that was found but does not lead anywhere is as unknown as before.
    if (result.followed.state == DriftState::following)
        return result;

    if (result.followed.state == DriftState::lost)
        return lostWindow (std::move (drift), result.followed.unexplained, std::move (result.followed.reason));

    return { drift, nothingNew (drift, DriftState::silent, 0, {}) };
}
} // namespace

SensedDrift startOfFollowing (const DriftLayout& layout, const DriftSpread& spread)
{
    return { startOfDrift (layout, spread) };
}

ModalModel followedModes (const ModalModel& model, double sampleRate)
{
    requireRealModes (model, "following a drift");
    const auto within = modesWithin (model, sampleRate);
    return firstModes (within, std::min (within.modes(), mostFollowed));
}

double followedLength (const DriftSettings& settings)
{
    return settings.memory + followedWindow + longestDelay + edges;
}

double followingMemory (const ModalModel& model)
{
    constexpr double left = 0.03, shortest = 0.1, longest = 0.5;
    return std::clamp (-std::log (left) / decayRates (model).minCoeff(), shortest, longest);
}

FollowedWindow followWindow (const ModalModel& nominal, const DriftSensor& sensor, const SensedDrift& before,
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

    const Heard heard { nominal, sensor, recording, settings };
    const auto isKnown = drift.scale != 0 && drift.lost < patience;
    return isKnown ? followNewest (heard, std::move (drift)) : acquire (heard, std::move (drift));
}
} // namespace antinode
