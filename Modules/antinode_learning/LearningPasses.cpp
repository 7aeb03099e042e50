#include "LearningPasses.h"

#include "CorrectedDesign.h"
#include "CubedVoltages.h"
#include "EquivalentLinear.h"
#include "LearningVerdict.h"
#include "PassLearner.h"
#include "PlayedVoltages.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>

#include <cmath>
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

/** A design that is corrected from play to play, and its voltages. */
struct Base
{
    FocusDesign design;
    Eigen::MatrixXd voltages;
};

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
    auto base = Base { result.design, voltages };
    const auto byModes = [&] (const Eigen::MatrixXd& played)
    { return modesOf (result.learnt, played, result.design.program.focusTime, settings); };
    const auto byModel = [&] (const Eigen::MatrixXd& played) -> Eigen::VectorXd
    { return nominal.model.shapes * byModes (played); };

    for (int i = 0; i < settings.passes; ++i)
    {
        auto pass = learner.hear (play (voltages, i));
        pass.design = result.design;
        result.passes.push_back (std::move (pass));
        result.learnt = learner.now();

        if ((i > 0 && isMisled (result.passes.back(), result.learnt))
            || ! doubtOf (result.passes.back(), result.learnt, nominal.model, deviations).empty())
            break;

        result.wide =
            wideWith (nominal, equivalentLinear (result.learnt, result.passes.back().voltages, settings.sampleRate,
                                                 result.passes.back().design.program.focusTime));
        result.design = designedAgain (result, focus, settings);
        voltages = voltagesNow();
        const auto asBase = fieldError (nominal.model.surface, byModel (base.voltages), byModel (voltages));

        if (const auto corrected = asBase < correctable ? correctedDesign (base.design, result.wide.model,
                                                                           byModes (voltages) - byModes (base.voltages))
                                                        : std::nullopt)
        {
            result.design = *corrected;
            voltages = voltagesNow();
        }
        else
            base = { result.design, voltages };

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
