#include "LearningPasses.h"

#include "LearningParameters.h"
#include "LearntDesign.h"
#include "PlayedRecording.h"
#include "PlayedVoltages.h"
#include "RecordingDelays.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/ModeWeighing.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr double correctable = 0.03; // of the field, RMS: designs that are farther off are made again

Playback playbackOf (const LearningSettings& settings)
{
    return { Reconstruction::bandLimited, settings.sampleRate };
}

WideModel wideWith (WideModel wide, const ModalModel& learnt)
{
    wide.model = learnt;
    return wide;
}

/** Velocities of all modes at the focus that voltages make, by what was learnt. */
Eigen::VectorXd modesOf (const LearntModes& learnt, const Eigen::MatrixXd& voltages, double focusTime,
                         const LearningSettings& settings)
{
    const auto focus = static_cast<Eigen::Index> (std::llround (focusTime * settings.sampleRate));
    const PlayedVoltages played (voltages, cubedVoltages (voltages), settings.sampleRate);
    return modeVelocities (learnt.model, played.distorted (learnt.distortions), focus + 1).bottomRows (1).transpose();
}

/** How far a field is from the one that is wanted: RMS over the surface, of the wanted one's. */
double fieldError (const Surface& surface, const Eigen::VectorXd& field, const Eigen::VectorXd& wanted)
{
    return std::sqrt (surface.areas.dot ((field - wanted).cwiseAbs2()) / surface.areas.dot (wanted.cwiseAbs2()));
}

/** A design to play, and its voltages. */
struct Planned
{
    FocusDesign design;
    Eigen::MatrixXd voltages;
};

Planned planned (FocusDesign design, const WideModel& wide, const LearningSettings& settings)
{
    auto voltages = playedVoltages (firstModes (wide.model, wide.known), design, settings);
    return { std::move (design), std::move (voltages) };
}

/** The base with what it lacks of the field that a new design makes, by what was learnt. None where it is too far off
    or cannot be corrected. */
std::optional<Planned> correctedPlan (const Planned& base, const Planned& again, const LearntFocus& learnt,
                                      const LearningSettings& settings)
{
    const auto& model = learnt.wide.model;
    const auto time = again.design.program.focusTime;
    const auto made = modesOf (learnt.learnt, base.voltages, time, settings),
               wanted = modesOf (learnt.learnt, again.voltages, time, settings);

    if (! (fieldError (model.surface, model.shapes * made, model.shapes * wanted) < correctable))
        return {};

    auto design = correctedDesign (base.design, model, wanted - made);

    if (! design)
        return {};

    if (design->spillOver)
        design->spillOver->share = spillOverShare (learnt.wide, *design);

    return planned (std::move (*design), learnt.wide, settings);
}

/** The focus with as many modes as at first, where it leaves their number open: with another one it would be another
    field, though no better. None where that cannot be done, or nothing is left open. */
std::optional<FocusDesign> designedAlike (const LearntFocus& learnt, const FocusDescription& focus,
                                          const LearningSettings& settings)
{
    const auto alike = withModesOf (focus, learnt.passes.front().design);

    if (alike.modes.count == focus.modes.count)
        return {};

    try
    {
        auto design = designWithin (learnt.wide, alike, playbackOf (settings), DesignExtent::compared);
        design.description.modes = focus.modes;
        design.choices.push_back (
            "As many modes are controlled as in the first play: " + std::to_string (*alike.modes.count) + ".");
        return design;
    }
    catch (const InputError&)
    {
        return {};
    }
}

/** The focus by what was learnt, or as it was played last where the limits allow no other. */
FocusDesign designedAgain (const LearntFocus& learnt, const FocusDescription& focus, const LearningSettings& settings)
{
    if (auto alike = designedAlike (learnt, focus, settings))
        return std::move (*alike);

    try
    {
        return designWithin (learnt.wide, focus, playbackOf (settings), DesignExtent::compared);
    }
    catch (const LimitError&)
    {
        return learnt.passes.back().design;
    }
}
} // namespace

Eigen::MatrixXd playedVoltages (const ModalModel& known, const FocusDesign& design, const LearningSettings& settings)
{
    return renderOffline (known, design.program,
                          { playbackOf (settings), settings.duration, 512, Eigen::MatrixXd (0, known.coordinates()) })
        .voltages;
}

LearntFocus learnFocus (const WideModel& nominal, const FocusDescription& focus, const std::vector<Sensor>& sensors,
                        const ModeSpread& deviations, const PassPlayer& play, const LearningSettings& settings,
                        const std::function<void (double)>& progress)
{
    LearntFocus result;
    result.wide = nominal;
    PassLearner learner (nominal, sensors, deviations);
    result.learnt = learner.now();
    result.design = designWithin (nominal, focus, playbackOf (settings), DesignExtent::compared);
    auto next = planned (result.design, nominal, settings), base = next;
    const auto byModel = [&] (const Eigen::MatrixXd& played) -> Eigen::VectorXd
    { return result.learnt.model.shapes * modesOf (result.learnt, played, result.design.program.focusTime, settings); };

    for (int i = 0; i < settings.passes; ++i)
    {
        auto pass = learner.hear (play (next.voltages, i));
        pass.design = result.design;
        result.passes.push_back (std::move (pass));
        result.learnt = learner.now();

        if ((i > 0 && isMisled (result.passes.back(), result.learnt))
            || ! doubtOf (result.passes.back(), result.learnt, nominal.model, deviations).empty())
            break;

        result.wide =
            wideWith (nominal, equivalentLinear (result.learnt, result.passes.back().voltages, settings.sampleRate,
                                                 result.passes.back().design.program.focusTime));
        auto again = planned (designedAgain (result, focus, settings), result.wide, settings);

        if (auto corrected = correctedPlan (base, again, result, settings))
            next = std::move (*corrected);
        else
            next = base = std::move (again);

        result.design = next.design;

        if (fieldError (nominal.model.surface, byModel (result.passes.back().voltages), byModel (next.voltages))
            < settings.enough)
            break;

        if (progress)
            progress (static_cast<double> (i + 1) / settings.passes);
    }

    const auto wanted = byModel (next.voltages);

    for (auto& pass : result.passes)
        pass.estimatedError = fieldError (nominal.model.surface, byModel (pass.voltages), wanted);

    result.refusal = result.passes.empty() ? std::string() : refusalOf (result, nominal.model, deviations);

    if (! result.refusal.empty())
    {
        result.kept = bestPredicted (result.passes);
        result.design = result.passes[result.kept].design;
        result.wide = nominal;
    }

    return result;
}

namespace
{
constexpr double mostUnexplained = 0.3; // of the signals, RMS
constexpr double farthest = 30;         // standard deviations that a frequency may be moved
constexpr double wellPredicted = 0.5;   // of what the nominal model does not predict, beyond the noise, RMS
constexpr double wellNearNoise = 0.5;   // of its power, where it is at most twice the noise, RMS
constexpr double surelyPredicted = 0.1; // of what the nominal model does not predict, RMS
constexpr double misled = 3;            // of the same: such a model is not played by again
constexpr double farFromPredicted = 10; // times louder or less loud: no device differs so much from its model
constexpr double leastBeyond = 0.1;     // of the noise's power: less is nothing to learn from
constexpr double stuck = 3;             // of the noise is not explained
constexpr double sameMove = 1.1;        // times: a move that is no farther is the one of before
constexpr double clearlyBetter = 0.5;   // of the first play's error

/** How many of its standard deviations the frequency that was moved most was moved. */
double farthestMove (const LearntModes& learnt, const ModalModel& nominal, const ModeSpread& deviations)
{
    const auto moves = (learnt.model.angularFrequencies.array() / nominal.angularFrequencies.array()).log();
    const auto expected = (deviations.frequencies.array().square() + deviations.drift * deviations.drift).sqrt();
    return (moves.abs() / expected.max (1e-9)).maxCoeff();
}

bool isClearlyBetter (const std::vector<LearningPass>& passes, std::size_t pass)
{
    return passes[pass].estimatedError < clearlyBetter * passes.front().estimatedError;
}

/** Whether what was learnt before a play predicts it much better than the nominal model, in powers beyond the noise,
    which nothing predicts.
    @param residual  of the noise that was said, what the fit leaves: less where the noise is smaller than that */
bool isWellPredicted (const LearningPass& pass, double residual)
{
    const auto noise = std::min (1.0, residual * residual);
    const auto learnt = pass.surprise * pass.surprise - noise;
    const auto nominal = pass.nominalSurprise * pass.nominalSurprise - noise;
    const auto share = std::clamp (1 / pass.nominalSurprise, wellPredicted * wellPredicted, wellNearNoise);
    return nominal > leastBeyond * noise && learnt < share * nominal;
}
} // namespace

std::string doubtOf (const LearningPass& pass, const LearntModes& learnt, const ModalModel& nominal,
                     const ModeSpread& deviations)
{
    constexpr double percent = 100;

    // Before what a fit says: a sensor that is dead is explained by ceramics that do nothing, or by nothing.
    if (! (pass.loudness > 1 / farFromPredicted && pass.loudness < farFromPredicted))
        return "Sensors hear " + inWords (percent * pass.loudness)
               + " % of what the previous device predicts; allowed: " + inWords (percent / farFromPredicted) + " to "
               + inWords (percent * farFromPredicted) + " %. Check sensors, channels and units.";

    if (! (learnt.unexplained < mostUnexplained))
        return "The model does not explain " + inWords (percent * learnt.unexplained)
               + " % of the signals; allowed: below " + inWords (percent * mostUnexplained)
               + " %. Check sensors, channels and places.";

    if (learnt.heldBackBefore > 0 && ! (learnt.heldBack < learnt.heldBackBefore))
        return "The model learnt from the other sensors leaves " + inWords (percent * learnt.heldBack)
               + " % of a held-back sensor unexplained, the previous device "
               + inWords (percent * learnt.heldBackBefore)
               + " %: it would make the device worse. Check places and channels, or measure at more points.";

    if (const auto move = farthestMove (learnt, nominal, deviations); ! (move < farthest))
        return "A frequency would be " + inWords (move) + " standard deviations off the previous device; allowed: "
               + inWords (farthest) + ". Check sensors, channels and places.";

    return {};
}

std::string refusalOf (const LearntFocus& learnt, const ModalModel& nominal, const ModeSpread& deviations)
{
    const auto& last = learnt.passes.back();

    if (auto doubt = doubtOf (last, learnt.learnt, nominal, deviations); ! doubt.empty())
        return doubt;

    if (learnt.passes.size() > 1 && ! isWellPredicted (last, learnt.learnt.residual))
        return "The learnt model did not predict the last play much better than the previous device.";

    // What predicts so well needs no other proof, whatever was left to gain.
    const auto isSure = last.surprise < surelyPredicted * last.nominalSurprise;

    if (learnt.passes.size() > 1 && ! isSure && ! isClearlyBetter (learnt.passes, learnt.passes.size() - 1))
        return "According to the learnt model the last play was hardly better than the first.";

    return {};
}

std::string warningOf (const LearntFocus& learnt)
{
    if (! learnt.refusal.empty() || ! isUnlikelyMove (learnt.learnt.largestMove))
        return {};

    return "A frequency is more than 6 of its standard deviations off the previous device. Give larger "
           "deviations "
           "of the frequencies, or retune the device first.";
}

bool isStuck (const LearntModes& learnt, double settledMove)
{
    return learnt.residual > stuck
           || (isUnlikelyMove (learnt.largestMove) && ! (learnt.largestMove < sameMove * settledMove));
}

bool isMisled (const LearningPass& pass, const LearntModes& learnt)
{
    return pass.surprise > misled * pass.nominalSurprise && isStuck (learnt);
}

std::size_t bestPredicted (const std::vector<LearningPass>& passes)
{
    const auto best =
        std::min_element (passes.begin(), passes.end(),
                          [] (const auto& one, const auto& other) { return one.surprise < other.surprise; });
    const auto index = static_cast<std::size_t> (best - passes.begin());
    const auto isMuchBetter =
        best->surprise < wellPredicted * passes.front().surprise && isClearlyBetter (passes, index);
    return isMuchBetter ? index : 0;
}

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
