#include "RenderedFocus.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_focus/EventPeak.h>
#include <antinode_focus/TargetField.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double minimumAftermath = 0.025; // s
constexpr int samplesHeard = 64;           // that the last sample of a free waveform lasts, kernel and latency included
constexpr double residualSpan = 0.002;     // s: a velocity that passes through zero just then is no rest

double defaultDuration (const FocusDesign& design)
{
    const auto focus = design.moments.back().time;
    auto end = std::max (2 * focus, focus + minimumAftermath);

    for (const auto& oscillation : design.program.oscillations)
        end = std::max (end, oscillation.end);

    if (const auto& samples = design.program.samples)
        end = std::max (end, samples->firstTime
                                 + static_cast<double> (samples->values.cols() + samplesHeard)
                                       / samples->playback.sampleRate);

    return design.restTime ? std::max (end, focus + *design.restTime + 1.5 * residualSpan) : end;
}

ReachedMoment reachedAt (const WideModel& wide, const FocusDesign& design, const FocusMoment& moment,
                         const Render& render, std::int64_t sample)
{
    const auto& model = wide.model;
    const auto truncatedPeak = largestTruncated (model, design, moment);
    const auto wantedPeak = moment.targets.empty()
                                ? truncatedPeak
                                : largestWanted (model.surface, moment.targets, design.description.edgeWindow);
    ReachedMoment reached;
    reached.sample = sample;
    reached.modalVelocities = render.modalVelocities.col (sample);
    reached.field = model.shapes * reached.modalVelocities;
    reached.peak = largestVelocity (model, reached.modalVelocities);
    reached.score = scoreFocus (model, reached.modalVelocities, moment.target.field, wantedPeak);
    reached.truncatedScore = scoreFocus (model, reached.modalVelocities, moment.truncatedField, truncatedPeak);
    reached.spillOver = spillOverShare (wide, reached.modalVelocities);
    return reached;
}

/** Later foci fall on samples counted from the first. */
std::vector<ReachedMoment> reachedMoments (const WideModel& wide, const FocusDesign& design, const Render& render)
{
    std::vector<ReachedMoment> reached;

    for (const auto& moment : design.moments)
    {
        const auto sample =
            render.focusSample + std::llround ((moment.time - design.program.focusTime) * render.sampleRate);

        if (sample >= render.modalVelocities.cols())
            throw InputError (
                "duration",
                "is " + inWords (static_cast<double> (render.modalVelocities.cols()) / render.sampleRate * 1000)
                    + " ms, which ends before the focus at " + inWords (moment.time * 1000) + " ms");

        reached.push_back (reachedAt (wide, design, moment, render, sample));
    }

    return reached;
}

/** None if there is no brake, or where it is not rendered to its end. */
std::optional<ResidualMotion> residualMotion (const RenderedFocus& focus)
{
    if (! focus.design.restTime)
        return {};

    const auto& render = focus.render;
    const auto first = focus.moments.back().sample
                       + static_cast<Eigen::Index> (std::ceil (*focus.design.restTime * render.sampleRate));
    const auto count = static_cast<Eigen::Index> (std::ceil (residualSpan * render.sampleRate));

    if (first + count > render.modalVelocities.cols())
        return {};

    const auto left =
        largestInEvent (focus.model, { render.modalVelocities, render.sampleRate }, {}, first, first + count - 1);
    return ResidualMotion { *focus.design.restTime, std::abs (left.velocity / focus.moments.back().peak.velocity) };
}

/** Of all foci of a train. */
std::vector<Target> allTargets (const FocusDesign& design)
{
    std::vector<Target> all;

    for (const auto& moment : design.moments)
        all.insert (all.end(), moment.targets.begin(), moment.targets.end());

    return all;
}

/** Fingers, and places where less is to be felt. */
std::vector<std::pair<double, double>> bystandersOf (const FocusDescription& focus)
{
    auto places = focus.felt ? focus.felt->places : std::vector<std::pair<double, double>>();

    for (const auto& finger : focus.fingers)
        places.emplace_back (finger.x, finger.y);

    return places;
}

std::vector<std::pair<double, double>> chooseProbes (const FocusDesign& design, const RenderOptions& options)
{
    if (! options.probes.empty())
        return options.probes;

    if (! design.description.probes.empty())
        return design.description.probes;

    std::vector<std::pair<double, double>> probes;

    for (const auto& target : design.description.targets)
        probes.emplace_back (target.x, target.y);

    return probes;
}

/** The voltages played again where fingers come and go. */
void addContacts (RenderedFocus& result, const ModalModel& model, const std::vector<Finger>& fingers,
                  const RenderSettings& settings)
{
    auto& render = result.render;
    auto motion = motionUnderFingers (model, fingers, settings.playback, render.voltages);
    render.modalVelocities = std::move (motion.modalVelocities);
    render.probeVelocities = settings.probeShapes * render.modalVelocities;
    render.focusVelocities = render.modalVelocities.col (render.focusSample);
    result.contacts = std::move (motion.histories);
}
} // namespace

RenderedFocus renderFocus (WideModel wide, FocusDesign design, const RenderOptions& options,
                           const std::function<void (double)>& progress)
{
    const auto& model = wide.model;
    RenderedFocus result;
    result.probes = chooseProbes (design, options);

    RenderSettings settings;
    settings.playback = options.playback;
    settings.duration = options.duration.value_or (defaultDuration (design));
    settings.blockSize = options.blockSize;
    settings.probeShapes.resize (static_cast<Eigen::Index> (result.probes.size()), model.coordinates());

    for (std::size_t i = 0; i < result.probes.size(); ++i)
        settings.probeShapes.row (static_cast<Eigen::Index> (i)) =
            shapesAt (model, result.probes[i].first, result.probes[i].second);

    const auto canLift = options.mayLiftOff && canLiftOff (design.description.fingers);

    result.render = renderOffline (model, design.program, settings, progress);

    if (canLift)
        addContacts (result, model, design.description.fingers, settings);

    result.moments = reachedMoments (wide, design, result.render);
    result.reachedField = result.moments.front().field;
    result.score = result.moments.front().score;
    result.truncatedScore = result.moments.front().truncatedScore;
    result.contrast = fieldContrast (model.surface, result.reachedField, design.moments.front().targets,
                                     result.moments.front().peak.velocity);
    result.known = wide.designed ? *std::move (wide.designed) : firstModes (model, wide.known);
    result.obstacle = std::move (wide.obstacle);
    result.model = std::move (wide.model);
    result.design = std::move (design);
    result.residual = residualMotion (result);

    if (needsLagFilters (result.model))
        result.undone = withLagsUndone (result.model, result.render.voltages, result.design.program.voltageLimits,
                                        result.render.sampleRate);

    if (options.repetitions && canLift)
        result.power =
            FocusPower { "fingers may lift off; it is computed for fingers that stay on the surface", {}, {} };
    else if (options.repetitions)
        result.power = focusPower (result.model, result.render.voltages, options.playback, *options.repetitions);

    if (options.threshold)
        result.felt = feltOutcome (result.model, result.render, allTargets (result.design), *options.threshold,
                                   bystandersOf (result.design.description));

    return result;
}

const Eigen::MatrixXd& outputVoltages (const RenderedFocus& focus)
{
    return focus.undone ? focus.undone->voltages : focus.render.voltages;
}

RenderedFocus renderFocus (ModalModel model, FocusDesign design, const RenderOptions& options,
                           const std::function<void (double)>& progress)
{
    const auto known = model.modes();
    return renderFocus (WideModel { std::move (model), known, "It was played with the modes of its design alone." },
                        std::move (design), options, progress);
}

double spillOverShare (const RenderedFocus& focus)
{
    double largest = 0;

    for (const auto& moment : focus.moments)
        largest = std::max (largest, moment.spillOver);

    return largest;
}

std::string spillOverInWords (const RenderedFocus& focus)
{
    const auto beyond = focus.model.modes() - focus.known.modes();

    if (beyond == 0 || ! focus.design.description.fingers.empty())
        return focus.obstacle;

    const auto highest = [] (const ModalModel& model) { return inWords (model.frequencyHz (model.modes() - 1)); };
    return inWords (100 * spillOverShare (focus)) + " % of the field is in " + std::to_string (beyond)
           + " modes beyond the " + std::to_string (focus.known.modes()) + " of the device, from "
           + highest (focus.known) + " Hz to " + highest (focus.model) + " Hz."
           + (focus.obstacle.empty() ? "" : " " + focus.obstacle);
}

std::string spillOverToText (const RenderedFocus& focus)
{
    return formatted ("%-14s %s", "spill-over", spillOverInWords (focus).c_str());
}
} // namespace antinode
