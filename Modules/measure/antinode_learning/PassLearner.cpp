#include "PassLearner.h"

#include "CubedVoltages.h"
#include "FirstDelays.h"
#include "LearningParameters.h"
#include "LearningVerdict.h"
#include "LowerRate.h"
#include "PlayPrediction.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr double wellExplained = 0.05; // of the signals, RMS: a delay that leaves less of the record is the right one
constexpr double foundDelay = 100e-6;  // s: deviation of a delay that was found by a model that is off

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
    return {
        model, sensors, {}, linear, linear, deviations.frequencies, deviations.dampings, deviations.participation, 0, 0,
        0,     0,       0,  0,      {}
    };
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

/** The device by all recordings; from its beginning again where the way from what was known gets stuck. A frequency
   that is as far off then too is so: later plays need not ask again. */
LearntModes PassLearner::learntWith (const ModeSpread& own)
{
    const auto isFirst = recordings.size() == 1;
    auto now = learnModes (nominal.model, sensors, own, recordings, isFirst ? nullptr : &learnt);

    if (isFirst || ! isStuck (now, settledMove))
        return now;

    auto again = learnModes (nominal.model, sensors, own, recordings);

    if (isBetter (again, now))
        now = std::move (again);

    settledMove = now.largestMove;
    return now;
}

/** s: the delays to try for a recording: one, or several for the first play. */
std::vector<double> PassLearner::delaysToTry (const PlayedRecording& recording, const ModeSpread& own) const
{
    if (recordings.empty())
        return firstDelays (nominal.model, sensors, own, recording);

    return delaysBy (meanModel (learnt.model, learnt.frequencyDeviations), learnt.sensors, recording, 1);
}
} // namespace antinode
