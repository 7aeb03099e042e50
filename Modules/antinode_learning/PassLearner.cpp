#include "PassLearner.h"

#include "CubedVoltages.h"
#include "LearningParameters.h"
#include "LearningVerdict.h"
#include "LowerRate.h"
#include "PlayPrediction.h"

#include <antinode_numerics/Median.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t mostLikely = 24; // delays of the first play that are compared by the beginning of the record
constexpr std::size_t mostTried = 5;   // of them that are tried on the whole record
constexpr double surelyRight = 1.5;    // times the noise: a delay that leaves less of the beginning is the right one
constexpr std::size_t fewCompared = 4; // so many delays are compared before one of them stands out
constexpr double farLess = 0.2;        // of the next one's misfit: what a delay leaves that stands out
constexpr double hardlyAny = 0.05;     // the same of the median of the others
constexpr double wellExplained = 0.05; // of the signals, RMS: a delay that leaves less of the record is the right one
constexpr double foundDelay = 100e-6;  // s: deviation of a delay that was found by a model that is off

/** Whether the least one is far less than all others. What modes beyond the model do is left by the right delay too, so
    the noise alone is no measure. */
bool oneStandsOut (std::vector<double> misfits)
{
    if (misfits.size() < fewCompared)
        return false;

    std::sort (misfits.begin(), misfits.end());
    const auto least = misfits[0], next = misfits[1];
    return least < farLess * next && least < hardlyAny * median ({ misfits.begin() + 1, misfits.end() });
}

using RankedDelays = std::array<std::vector<std::pair<double, double>>, 2>; // misfit and delay, by each bound

/** s: the likeliest delay by the correlation, since beginnings can mislead, then those that explain the beginning best,
    those of the two bounds in turn. */
std::vector<double> delaysWorthTrying (RankedDelays ranked, double likeliest)
{
    std::vector<double> best { likeliest };

    for (auto& each : ranked)
        std::sort (each.begin(), each.end());

    for (std::size_t i = 0; i < ranked[0].size() && best.size() < mostTried; ++i)
        for (const auto& each : ranked)
            if (std::find (best.begin(), best.end(), each[i].second) == best.end())
                best.push_back (each[i].second);

    best.resize (std::min (best.size(), mostTried));
    return best;
}

/** The model whose response is the mean response of devices with scattered frequencies: their phases drift apart, which
    acts like more damping.
    @param frequencyDeviations  N_m, relative */
ModalModel meanModel (ModalModel model, const Eigen::VectorXd& frequencyDeviations)
{
    model.dampingRatios += frequencyDeviations;
    return model;
}

/** What is learnt from: with cubes where ceramics may distort, and only what lies where the model has modes. */
PlayedRecording asHeard (PlayedRecording recording, const WideModel& nominal, const ModeSpread& deviations)
{
    if (deviations.distortion > 0)
        recording.cubes = cubedVoltages (recording.voltages);

    return withinModel (std::move (recording), nominal);
}

/** A device before anything is heard of it. */
LearntModes asGiven (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations)
{
    const Eigen::VectorXd linear = Eigen::VectorXd::Zero (model.actuators());
    return { model, sensors, {}, linear, linear, deviations.frequencies, deviations.dampings, deviations.participation,
             0,     0,       0,  0 };
}

/** A fit without a sign of a wrong minimum comes first, then the more probable one. */
bool isBetter (const LearntModes& one, const LearntModes& other)
{
    const auto isOneMissed = isMissed (one);
    return isOneMissed == isMissed (other) ? one.distance < other.distance : ! isOneMissed;
}
} // namespace

PassLearner::PassLearner (const WideModel& model, const std::vector<Sensor>& listening, const ModeSpread& spread)
    : nominal (model), sensors (listening), deviations (spread), learnt (asGiven (model.model, listening, spread))
{
}

LearningPass PassLearner::hear (const PlayedRecording& whole)
{
    requireUsable (nominal.model, sensors, deviations, { whole });
    const auto recording = asHeard (whole, nominal, deviations);
    auto own = deviations;
    LearningPass pass;
    pass.voltages = whole.voltages;
    pass.loudness = loudnessOf (nominal.model, sensors, recording);
    pass.surprise = surprise (learnt, deviations, recording);
    pass.nominalSurprise = recordings.empty()
                               ? pass.surprise
                               : surprise (asGiven (nominal.model, sensors, deviations), deviations, recording);

    if (recording.delaySpan > 0)
        own.delay = std::max (own.delay, foundDelay);

    std::optional<LearntModes> best;
    auto chosen = recording.delay;

    for (const auto delay : delaysToTry (recording, own))
    {
        recordings.push_back (withDelay (recording, delay));

        if (auto now = learntWith (own); ! best || isBetter (now, *best))
        {
            best = std::move (now);
            chosen = delay;
        }

        recordings.pop_back();

        if (best->unexplained < wellExplained && ! isUnlikelyMove (best->largestMove))
            break;
    }

    recordings.push_back (withDelay (recording, chosen));
    learnt = std::move (*best);
    pass.delay = learnt.delays[learnt.delays.size() - 1];
    return pass;
}

/** The device by all recordings; from its beginning again where the way from what was known gets stuck. */
LearntModes PassLearner::learntWith (const ModeSpread& own) const
{
    const auto isFirst = recordings.size() == 1;
    auto now = learnModes (nominal.model, sensors, own, recordings, isFirst ? nullptr : &learnt);

    if (! isFirst && isStuck (now))
        if (auto again = learnModes (nominal.model, sensors, own, recordings); isBetter (again, now))
            return again;

    return now;
}

/** s: the delays to try for a recording: one, or several for the first play. */
std::vector<double> PassLearner::delaysToTry (const PlayedRecording& recording, const ModeSpread& own) const
{
    const auto mean = meanModel (learnt.model, learnt.frequencyDeviations);
    auto delays = delaysBy (mean, learnt.sensors, recording, recordings.empty() ? mostLikely : 1);

    if (delays.size() == 1)
        return delays;

    RankedDelays ranked;
    std::vector<double> least; // of both bounds

    for (const auto delay : delays)
    {
        const auto misfits =
            misfitsOfBeginning (nominal.model, sensors, own, withDelay (recording, delay), surelyRight);
        ranked[0].emplace_back (misfits[0], delay);
        ranked[1].emplace_back (misfits[1], delay);
        least.push_back (std::min (misfits[0], misfits[1]));

        if (least.back() < surelyRight)
            return { delay };

        if (oneStandsOut (least))
            return { delays[static_cast<std::size_t> (std::min_element (least.begin(), least.end()) - least.begin())] };
    }

    return delaysWorthTrying (std::move (ranked), delaysBy (nominal.model, sensors, recording, 1).front());
}
} // namespace antinode
