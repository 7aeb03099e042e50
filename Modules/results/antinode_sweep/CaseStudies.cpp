#include "CaseStudies.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_fingers/OneSidedContact.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/Prediction.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_render/Summary.h>
#include <antinode_tracks/LiveTracks.h>

#include <algorithm>

namespace antinode
{
namespace
{
bool isRecorded (const SweepPlan& plan, std::string_view prefix)
{
    return std::any_of (plan.record.begin(), plan.record.end(),
                        [&] (const auto& key) { return key.starts_with (prefix); });
}

DesignExtent neededExtent (const SweepPlan& plan)
{
    const auto isComplete =
        isRecorded (plan, "lower_bound") || isRecorded (plan, "shortest_period") || isRecorded (plan, "limit.");
    return isComplete ? DesignExtent::complete : DesignExtent::compared;
}

/** The field at the points of a plan, mm/s. */
nlohmann::ordered_json fieldAt (const ModalModel& model, const Eigen::VectorXd& velocities, const SweepPlan& plan)
{
    auto list = nlohmann::ordered_json::array();

    for (const auto& [x, y] : plan.points)
        list.push_back (shapesAt (model, x, y).dot (velocities) * milli);

    return list;
}

void addScores (nlohmann::ordered_json& summary, const FocusScore& score, const std::string& ending)
{
    summary["v_score" + ending] = score.vScore;
    summary["field_error" + ending] = score.fieldError;
    summary["peak_ratio" + ending] = score.peakRatio;
}
} // namespace

FocusStudy::FocusStudy (const SweepInputs& inputs, bool usesCacheToUse)
    : given (inputs), playback { Reconstruction::bandLimited, inputs.plan.sampleRate },
      extent (neededExtent (inputs.plan)), usesCache (usesCacheToUse), devices (devicesToKeep), designs (designsToKeep)
{
}

void FocusStudy::check (const CaseKeys& all) const
{
    readDevice (deviceDocument (given, all), "case 0: device");
    focusFromDocument (assigned (given.focus(), keysOf (all, "focus.")), "case 0: focus", "focus");
}

std::shared_ptr<const Setup> FocusStudy::deviceOf (const CaseKeys& all) const
{
    const auto solve = [&] { return setUp (readDevice (deviceDocument (given, all), "device"), playback, usesCache); };
    return devices.get (deviceText (all), solve);
}

std::shared_ptr<const FocusStudy::MadeDesign> FocusStudy::designOf (const CaseKeys& all) const
{
    const auto keys = keysOf (all, "focus.");
    const auto make = [&]
    {
        const auto focus = focusFromDocument (assigned (given.focus(), keys), "focus", "focus");
        const auto device = deviceOf (all);
        MadeDesign design { designWide (device->wide, focus, playback, device->widen, extent), {}, {}, {} };
        const auto& model = design.made.wide.model;
        const auto& moment = design.made.design.moments.front();
        design.modes = withoutShapes (model);
        design.truncatedPeak = largestTruncated (model, design.made.design, moment);
        design.wantedPeak = largestWanted (model.surface, moment.targets, focus.edgeWindow);
        return design;
    };
    return designs.get (deviceText (all) + "\n" + textOf (keys), make);
}

nlohmann::ordered_json FocusStudy::closedForm (const MadeDesign& designed, const Deviation& deviation,
                                               std::uint64_t seed) const
{
    const auto& [wide, design] = designed.made;
    const auto& moment = design.moments.front();

    if (canLiftOff (design.description.fingers))
        throw InputError ("evaluate", "is closed_form, which does not support fingers that lift off; allowed: render");

    const auto states = predictStates (deviation.isNone() ? designed.modes : deviated (designed.modes, deviation, seed),
                                       design.program, moment.time);
    const auto velocities = modalVelocities (designed.modes, states);
    nlohmann::ordered_json summary { { "modes_controlled", design.controlledModes.size() },
                                     { "captured", design.captured },
                                     { "residue", design.residue },
                                     { "peak_voltage_V", peakVoltage (design) },
                                     { "voltage_limit_V", design.program.voltageLimits.maxCoeff() } };
    summary["spill_over"] = { { "share", spillOverShare (wide, velocities) } };
    addScores (summary, scoreFocus (wide.model, velocities, moment.target.field, designed.wantedPeak), {});
    addScores (summary, scoreFocus (wide.model, velocities, moment.truncatedField, designed.truncatedPeak),
               "_truncated");
    summary[pointKey] = fieldAt (wide.model, velocities, given.plan);
    return summary;
}

nlohmann::ordered_json FocusStudy::rendered (const MadeDesign& designed, const Deviation& deviation,
                                             std::uint64_t seed) const
{
    auto wide = designed.made.wide;
    RenderOptions options;
    options.playback = playback;

    if (! deviation.isNone())
        wide.model = deviated (wide.model, deviation, seed);

    if (isRecorded (given.plan, "power."))
        options.repetitions = 10; // as `antinode render` has it

    if (isRecorded (given.plan, "felt."))
        options.threshold = findSkinThreshold ({});

    const auto focus = renderFocus (std::move (wide), designed.made.design, options);
    auto summary = summaryToJson (focus, evaluateOutcome (focus));
    summary[pointKey] = fieldAt (focus.model, focus.moments.front().modalVelocities, given.plan);
    return summary;
}

nlohmann::ordered_json FocusStudy::summary (const CaseKeys& all, const Deviation& deviation, std::uint64_t seed) const
{
    const auto designed = designOf (all);

    if (! deviation.isNone())
        requireRealModes (designed->made.wide.model, "deviations");

    return given.plan.evaluation == SweepEvaluation::closedForm ? closedForm (*designed, deviation, seed)
                                                                : rendered (*designed, deviation, seed);
}

WaveformsStudy::WaveformsStudy (const SweepInputs& inputs, bool usesCacheToUse)
    : given (inputs), usesCache (usesCacheToUse), devices (devicesToKeep), designs (designsToKeep)
{
    settings.sampleRate = inputs.plan.sampleRate;
    settings.latency = inputs.plan.latency;
    settings.threshold = findSkinThreshold ({});
}

WaveformsDescription WaveformsStudy::waveformsOf (const CaseKeys& all, const std::string& source) const
{
    return waveformsFromDocument (assigned (given.waveforms(), keysOf (all, "waveforms.")), source, "waveforms");
}

void WaveformsStudy::check (const CaseKeys& all) const
{
    readDevice (deviceDocument (given, all), "case 0: device");
    waveformsOf (all, "case 0: waveforms");
}

nlohmann::ordered_json WaveformsStudy::summary (const CaseKeys& all, const Deviation& deviation,
                                                std::uint64_t seed) const
{
    const auto solve = [&] { return trackModels (readDevice (deviceDocument (given, all), "device"), usesCache); };
    const auto models = devices.get (deviceText (all), solve);
    const auto make = [&]
    {
        const auto waveforms = waveformsOf (all, "waveforms");
        return settings.latency > 0 ? designLiveTracks (models->known, waveforms, settings)
                                    : designTracks (models->known, waveforms, settings);
    };
    const auto design = designs.get (deviceText (all) + "\n" + textOf (keysOf (all, "waveforms.")), make);

    if (deviation.isNone())
        return performedToJson (performDesigned (models->judge, *design, settings.threshold));

    requireRealModes (models->judge, "deviations");
    return performedToJson (performDesigned (deviated (models->judge, deviation, seed), *design, settings.threshold));
}
} // namespace antinode
