#include "LearningPasses.h"

#include "LearningVerdict.h"
#include "LikelyDelays.h"
#include "RecordingEquations.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
Playback playbackOf (const LearningSettings& settings)
{
    return { Reconstruction::bandLimited, settings.sampleRate };
}

WideModel wideWith (WideModel wide, const ModalModel& learnt)
{
    wide.model = learnt;
    return wide;
}

/** What sensors would hear without delay until the voltages end: samples x N. Later phases of a model that is off are
    no help to find a delay. */
Eigen::MatrixXd predictedWhilePlayed (const ModalModel& model, const std::vector<Sensor>& sensors,
                                      const PlayedRecording& recording)
{
    const PlayedVoltages voltages (recording.voltages, recording.sampleRate);
    const auto velocities = modeVelocities (model, voltages, voltages.drivenSamples());
    Eigen::MatrixXd signals (velocities.rows(), std::ssize (sensors));

    for (std::size_t m = 0; m < sensors.size(); ++m)
        signals.col (static_cast<Eigen::Index> (m)) = velocities * sensors[m].shapes.transpose();

    return signals;
}

/** What sensors hear until the voltages have ended, of what a model predicts of it: RMS, the median of the sensors. */
double loudnessOf (const ModalModel& model, const std::vector<Sensor>& sensors, const PlayedRecording& recording)
{
    const auto predicted = predictedWhilePlayed (model, sensors, recording);
    const auto latest = (recording.delay + recording.delaySpan) * recording.sampleRate;
    const auto samples =
        std::min (recording.signals.cols(), predicted.rows() + static_cast<Eigen::Index> (std::ceil (latest)));
    const Eigen::VectorXd heard = recording.signals.leftCols (samples).rowwise().norm();
    const Eigen::VectorXd ratios = heard.array() / predicted.colwise().norm().transpose().array().max (1e-300);
    return median ({ ratios.begin(), ratios.end() });
}

/** A device that answers as devices do in the mean whose frequencies are off by so many deviations: their phases part,
    as if modes were damped more. */
ModalModel inTheMean (ModalModel model, const Eigen::VectorXd& frequencyDeviations)
{
    model.dampingRatios += frequencyDeviations;
    return model;
}

/** The same recording for each delay that it may have, the most likely one first; alone where the delay is known. */
std::vector<PlayedRecording> withLikelyDelays (const ModalModel& model, const std::vector<Sensor>& sensors,
                                               const PlayedRecording& recording, std::size_t most)
{
    if (! (recording.delaySpan > 0))
        return { recording };

    std::vector<PlayedRecording> result;

    for (const auto delay : likelyDelays (recording, predictedWhilePlayed (model, sensors, recording), most))
    {
        result.push_back (recording);
        result.back().delay = delay;
        result.back().delaySpan = 0;
    }

    return result;
}

/** RMS of what a model does not predict of a recording, of the noise; by the most likely delay for this model. */
double surprise (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                 const PlayedRecording& recording)
{
    const auto one = withLikelyDelays (model, sensors, recording, 1);
    const auto prior = makePrior (model, sensors, deviations, one);
    LearningParameters none;
    none.recordings = 1;
    const auto state = stateAt (prior, none, Eigen::VectorXd::Zero (none.size()));
    const auto samples = comparableSamples (one.front());
    const auto misfit = recordingMisfit (prior, state, 0, samples);
    return std::sqrt (misfit.residual / misfit.samples);
}

/** The field at the focus that voltages make, by a model. */
Eigen::VectorXd fieldOf (const ModalModel& model, const Eigen::MatrixXd& voltages, double focusTime,
                         const LearningSettings& settings)
{
    const auto focus = static_cast<Eigen::Index> (std::llround (focusTime * settings.sampleRate));
    const auto velocities = modeVelocities (model, { voltages, settings.sampleRate }, focus + 1);
    return model.shapes * velocities.bottomRows (1).transpose();
}

/** How far a field is from the one that is wanted: RMS over the surface, of the wanted one's. */
double fieldError (const Surface& surface, const Eigen::VectorXd& field, const Eigen::VectorXd& wanted)
{
    return std::sqrt (surface.areas.dot ((field - wanted).cwiseAbs2()) / surface.areas.dot (wanted.cwiseAbs2()));
}

/** The focus by what was learnt, or as it was played last where the limits allow no other. */
FocusDesign designedAgain (const LearntFocus& learnt, const FocusDescription& focus, const LearningSettings& settings)
{
    try
    {
        return designWithin (learnt.wide, focus, playbackOf (settings), DesignExtent::compared);
    }
    catch (const LimitError&)
    {
        return learnt.passes.back().design;
    }
}

/** A play of a device that is not known, learnt from again and again. */
class PassLearner
{
public:
    PassLearner (const WideModel& model, const std::vector<Sensor>& listening, const ModeSpread& spread)
        : nominal (model), sensors (listening),
          deviations (spread), learnt { model.model,          listening, {}, spread.frequencies, spread.dampings,
                                        spread.participation, 0,         0 }
    {
    }

    /** Learns from a play and those before.
        @return  what it was before: surprises and the delay */
    LearningPass hear (const PlayedRecording& recording)
    {
        constexpr double wellExplained = 0.05; // of the signals: no other delay is tried
        requireUsable (nominal.model, sensors, deviations, { recording });
        auto own = deviations;
        LearningPass pass;
        pass.voltages = recording.voltages;
        pass.loudness = loudnessOf (nominal.model, sensors, recording);
        pass.surprise = surprise (learnt.model, learnt.sensors, deviations, recording);
        pass.nominalSurprise = surprise (nominal.model, sensors, deviations, recording);

        if (recording.delaySpan > 0)
            own.delay = std::max (own.delay, foundDelay);

        std::optional<LearntModes> best;
        PlayedRecording chosen;

        for (auto& candidate : withDelaysToTry (recording, own))
        {
            recordings.push_back (std::move (candidate));
            auto now = learnModes (nominal.model, sensors, own, recordings, recordings.size() > 1 ? &learnt : nullptr);

            if (recordings.size() > 1 && isStuck (now))
                if (auto again = learnModes (nominal.model, sensors, own, recordings); again.residual < now.residual)
                    now = std::move (again);

            if (! best || now.residual < best->residual)
            {
                best = std::move (now);
                chosen = std::move (recordings.back());
            }

            recordings.pop_back();

            if (best->unexplained < wellExplained)
                break;
        }

        recordings.push_back (std::move (chosen));
        learnt = std::move (*best);
        pass.delay = learnt.delays[learnt.delays.size() - 1];
        return pass;
    }

    const LearntModes& now() const { return learnt; }

private:
    /** The recording by the delays that it may have: of the first play, of which nothing is known, several, the one
        first by which its beginning is explained best. */
    std::vector<PlayedRecording> withDelaysToTry (const PlayedRecording& recording, const ModeSpread& own) const
    {
        constexpr std::size_t mostLikely = 24, mostTried = 4;
        const auto mean = inTheMean (learnt.model, learnt.frequencyDeviations);
        auto candidates = withLikelyDelays (mean, learnt.sensors, recording, recordings.empty() ? mostLikely : 1);

        if (candidates.size() < 2)
            return candidates;

        std::vector<std::pair<double, PlayedRecording>> ranked;

        for (auto& candidate : candidates)
        {
            const auto misfit = misfitOfBeginning (nominal.model, sensors, own, candidate);
            ranked.emplace_back (misfit, std::move (candidate));
        }

        std::sort (ranked.begin(), ranked.end(), [] (const auto& a, const auto& b) { return a.first < b.first; });
        candidates.clear();

        for (auto& [misfit, candidate] : ranked)
            if (candidates.size() < mostTried)
                candidates.push_back (std::move (candidate));

        return candidates;
    }

    static constexpr double foundDelay = 100e-6; // s: deviation of a delay that was found by a model that is off

    const WideModel& nominal;
    const std::vector<Sensor>& sensors;
    const ModeSpread& deviations;
    std::vector<PlayedRecording> recordings;
    LearntModes learnt;
};
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
    const auto voltagesNow = [&]
    { return playedVoltages (firstModes (result.wide.model, result.wide.known), result.design, settings); };
    auto voltages = voltagesNow();
    const auto byModel = [&] (const Eigen::MatrixXd& played)
    { return fieldOf (result.learnt.model, played, result.design.program.focusTime, settings); };

    for (int i = 0; i < settings.passes; ++i)
    {
        auto pass = learner.hear (play (voltages, i));
        pass.design = result.design;
        result.passes.push_back (std::move (pass));
        result.learnt = learner.now();

        if ((i > 0 && isMisled (result.passes.back(), result.learnt))
            || ! doubtOf (result.passes.back(), result.learnt, nominal.model, deviations).empty())
            break;

        result.wide = wideWith (nominal, result.learnt.model);
        result.design = designedAgain (result, focus, settings);
        voltages = voltagesNow();

        if (fieldError (nominal.model.surface, byModel (result.passes.back().voltages), byModel (voltages))
            < settings.enough)
            break;

        if (progress)
            progress (static_cast<double> (i + 1) / settings.passes);
    }

    const auto wanted = byModel (voltages);

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
} // namespace antinode
