#include "LearningPasses.h"

#include "RecordingEquations.h"
#include "ShiftedSignals.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_engine/OfflineRender.h>

#include <cmath>

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

/** RMS of what a model does not predict of a recording, of the noise. */
double surprise (const ModalModel& model, const std::vector<Sensor>& sensors, const ModeSpread& deviations,
                 const PlayedRecording& recording)
{
    const std::vector<PlayedRecording> one { recording };
    const auto prior = makePrior (model, sensors, deviations, one);
    LearningParameters none;
    none.recordings = 1;
    const auto state = stateAt (prior, none, Eigen::VectorXd::Zero (none.size()));
    const auto samples = comparableSamples (recording);
    return std::sqrt (recordingMisfit (prior, state, 0, samples)
                      / static_cast<double> (recording.signals.rows() * samples));
}

/** How far the field at the focus is from the wanted one, by a model. */
double estimatedError (const ModalModel& model, const LearningPass& pass, const LearningSettings& settings)
{
    const auto focus = static_cast<Eigen::Index> (std::llround (pass.design.program.focusTime * settings.sampleRate));
    const auto velocities = modeVelocities (model, { pass.voltages, settings.sampleRate }, focus + 1);
    const Eigen::VectorXd field = model.shapes * velocities.bottomRows (1).transpose();
    const auto& areas = model.surface.areas;
    const auto square = [&] (const Eigen::VectorXd& values) { return areas.dot (values.cwiseAbs2()); };
    return std::sqrt (square (field - pass.design.truncatedField) / square (pass.design.truncatedField));
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

constexpr double mostUnexplained = 0.3; // of the signals, RMS

bool isExplained (const LearntModes& learnt)
{
    return learnt.unexplained < mostUnexplained;
}

/** Why what was learnt is not used; empty: it is. */
std::string refusalOf (const LearntFocus& learnt)
{
    constexpr double percent = 100;
    const auto& last = learnt.passes.back();

    if (! isExplained (learnt.learnt))
        return "The model does not explain " + inWords (percent * learnt.learnt.unexplained)
               + " % of the signals; allowed: below " + inWords (percent * mostUnexplained)
               + " %. Check sensors, channels and places.";

    if (learnt.passes.size() > 1 && ! (last.surprise < last.nominalSurprise))
        return "What was learnt predicted the last play no better than the device as it was known.";

    return {};
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
    result.learnt.model = nominal.model;
    result.learnt.sensors = sensors;
    result.learnt.frequencyDeviations = deviations.frequencies;
    result.learnt.dampingDeviations = deviations.dampings;
    std::vector<PlayedRecording> recordings;

    for (int i = 0; i < settings.passes; ++i)
    {
        LearningPass pass;
        pass.design = i == 0 ? designWithin (nominal, focus, playbackOf (settings), DesignExtent::compared)
                             : designedAgain (result, focus, settings);
        pass.voltages = playedVoltages (firstModes (result.wide.model, result.wide.known), pass.design, settings);
        recordings.push_back (play (pass.voltages, i));
        pass.voltages = recordings.back().voltages;
        pass.surprise = surprise (result.learnt.model, result.learnt.sensors, deviations, recordings.back());
        pass.nominalSurprise = surprise (nominal.model, sensors, deviations, recordings.back());
        result.passes.push_back (std::move (pass));
        result.learnt = learnModes (nominal.model, sensors, deviations, recordings, i > 0 ? &result.learnt : nullptr);
        result.wide = wideWith (nominal, result.learnt.model);

        if (! isExplained (result.learnt))
            break;

        if (progress)
            progress (static_cast<double> (i + 1) / settings.passes);
    }

    for (auto& pass : result.passes)
        pass.estimatedError = estimatedError (result.learnt.model, pass, settings);

    if (result.passes.empty())
    {
        result.design = designWithin (nominal, focus, playbackOf (settings), DesignExtent::compared);
        return result;
    }

    result.refusal = refusalOf (result);
    result.design = result.passes.front().design;

    if (result.refusal.empty())
        result.design = designedAgain (result, focus, settings);
    else
        result.wide = nominal;

    return result;
}
} // namespace antinode
