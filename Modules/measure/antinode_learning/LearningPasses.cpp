#include "LearningPasses.h"

#include "CorrectedDesign.h"
#include "CubedVoltages.h"
#include "EquivalentLinear.h"
#include "LearningVerdict.h"
#include "PassLearner.h"
#include "PlayedVoltages.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/ModeWeighing.h>

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
} // namespace antinode
