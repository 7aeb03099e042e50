#include "FollowWindow.h"

#include "PlayedRecording.h"
#include "PlayedVoltages.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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

namespace
{
/** Of a parabola through three values at -1, 0 and 1: where its extreme is. */
double extremeOf (double before, double middle, double after)
{
    const auto curvature = before - 2 * middle + after;
    return curvature == 0 ? 0 : std::clamp ((before - after) / (2 * curvature), -0.5, 0.5);
}

/** A signal, and what the lowest modes make of the voltages that were played meanwhile. */
class Correlations
{
public:
    Correlations (const ModalModel& lowest, const Eigen::RowVectorXd& shapesToUse, const PlayedRecording& recording,
                  double memory, double longest)
        : model (lowest), shapes (shapesToUse), rate (recording.sampleRate), samples (recording.voltages.cols()),
          lags (std::min (samples, static_cast<Eigen::Index> (std::ceil (longest * rate)) + 1)),
          first (std::min (samples, static_cast<Eigen::Index> (std::ceil (memory * rate)))),
          length (quickLength (static_cast<double> (samples + lags))),
          forces (PlayedVoltages (recording.voltages, rate).forces (model.participation))
    {
        Eigen::VectorXd signal = recording.signals.row (0).transpose();
        signal.head (first).setZero();
        norm = signal.norm();
        heard = tables.forward (signal, length);
    }

    /** By how much all frequencies are off: the delay that explains most, to a fraction of a sample.
        @param finer  into how many parts a sample is divided */
    AcquiredSensor at (double logarithm, Eigen::Index finer)
    {
        checkWatch();
        const auto predicted = predict (logarithm);

        if (! predicted.any() || ! (norm > 0))
            return {};

        const Eigen::VectorXcd spectrum = tables.forward (predicted, length).conjugate().cwiseProduct (heard);
        Eigen::VectorXcd padded = Eigen::VectorXcd::Zero (finer * length / 2 + 1);
        padded.head (spectrum.size()) = static_cast<double> (finer) * spectrum;
        const auto products = tables.inverse (padded, finer * length);
        Eigen::Index best = 0;
        const auto searched = finer * (lags - 1) + 1;
        products.head (searched).cwiseAbs().maxCoeff (&best);
        best = earlierAlike (products.head (searched), best,
                             static_cast<Eigen::Index> (std::llround (apart * rate * static_cast<double> (finer))));
        const auto near = [&] (Eigen::Index lag) { return products[(lag + products.size()) % products.size()]; };
        const auto delay = static_cast<double> (best) + extremeOf (near (best - 1), near (best), near (best + 1));
        const auto product = std::abs (products[best]);
        const auto energy = energyOf (predicted, best / finer);
        // Frequencies that are a little off lower the product, what is not modelled raises the norm.
        const auto scale = std::sqrt (product / energy * norm / std::sqrt (energy));
        return { std::max (0.0, delay) / (rate * static_cast<double> (finer)), std::copysign (scale, products[best]),
                 logarithm, std::min (1.0, product / (norm * std::sqrt (energy))) };
    }

private:
    static constexpr double apart = 0.05; // s: less is another period of the same mode

    /** What is played again and again is heard one period later as well: of delays that explain alike the shortest. */
    static Eigen::Index earlierAlike (const Eigen::VectorXd& products, Eigen::Index best, Eigen::Index distance)
    {
        constexpr double alike = 0.95;

        while (best > distance)
        {
            Eigen::Index earlier = 0;

            if (products.head (best - distance).cwiseAbs().maxCoeff (&earlier) < alike * std::abs (products[best]))
                break;

            best = earlier;
        }

        return best;
    }

    /** Of what is compared at a delay, samples. */
    double energyOf (const Eigen::VectorXd& predicted, Eigen::Index delay) const
    {
        const auto begin = std::max<Eigen::Index> (0, first - delay);
        const auto count = std::max<Eigen::Index> (1, samples - delay - begin);
        return std::max (predicted.segment (begin, count).squaredNorm(), 1e-300);
    }

    Eigen::VectorXd predict (double logarithm) const
    {
        Eigen::VectorXd predicted = Eigen::VectorXd::Zero (samples);

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            predicted += shapes[k]
                         * modeMotion (model.angularFrequencies[k] * std::exp (logarithm), model.dampingRatios[k],
                                       forces.col (k), rate, samples, false)
                               .velocity;

        predicted.head (std::max<Eigen::Index> (0, first - lags)).setZero();
        return predicted;
    }

    const ModalModel& model;
    Eigen::RowVectorXd shapes;
    double rate;
    Eigen::Index samples, lags, first, length;
    Eigen::MatrixXd forces;
    FourierTables tables;
    Eigen::VectorXcd heard; // spectrum of the compared part, the rest silent
    double norm = 0;
};

/** Those that explain nearly as much as the best, each at a delay of its own.
    @param apart  s: delays that differ by less are the same */
std::vector<AcquiredSensor> likeliest (std::vector<AcquiredSensor> found, double apart)
{
    constexpr double nearly = 0.9;
    constexpr std::size_t most = 4;
    std::sort (found.begin(), found.end(), [] (const auto& a, const auto& b) { return a.explained > b.explained; });
    std::vector<AcquiredSensor> likely;

    for (const auto& sensor : found)
    {
        const auto isSame = [&] (const AcquiredSensor& other) { return std::abs (other.delay - sensor.delay) < apart; };

        if (likely.size() < most && sensor.explained >= nearly * found.front().explained
            && std::none_of (likely.begin(), likely.end(), isSame))
            likely.push_back (sensor);
    }

    return likely;
}
} // namespace

std::vector<AcquiredSensor> likelySensors (const ModalModel& nominal, const Eigen::RowVectorXd& shapes,
                                           const PlayedRecording& recording, const DriftSettings& settings,
                                           double longest)
{
    constexpr Eigen::Index finer = 8;
    const auto model = firstModes (nominal, modesForSearch (nominal));
    Correlations correlations (model, shapes.head (model.modes()), atLowerRate (recording, highestModelled (model)),
                               settings.memory, longest);
    // Halfway between steps of the jump search the wrong delay explains more.
    constexpr double parts = 4;
    const auto step = jumpStep (nominal, settings) / parts;
    const auto steps = std::lround (settings.largestJump / step);
    std::vector<AcquiredSensor> found;

    for (auto i = -steps; i <= steps; ++i)
        if (const auto sensor = correlations.at (static_cast<double> (i) * step, 1); sensor.explained > 0)
            found.push_back (sensor);

    auto likely = likeliest (std::move (found), std::numbers::pi / (2 * model.angularFrequencies[model.modes() - 1]));

    for (auto& sensor : likely)
        sensor = correlations.at (sensor.jump, finer);

    return likely;
}
} // namespace antinode
