#include "Summary.h"

#include "FocusOutcome.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/EventPeak.h>
#include <antinode_focus/LimitUse.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
nlohmann::ordered_json fociJson (const RenderedFocus& focus)
{
    auto list = nlohmann::ordered_json::array();

    for (const auto& moment : focus.moments)
        list.push_back ({ { "time_ms", static_cast<double> (moment.sample) / focus.render.sampleRate * 1000 },
                          { "v_score", moment.score.vScore },
                          { "field_error", moment.score.fieldError },
                          { "peak_ratio", moment.score.peakRatio },
                          { "v_score_truncated", moment.truncatedScore.vScore },
                          { "field_error_truncated", moment.truncatedScore.fieldError },
                          { "peak_ratio_truncated", moment.truncatedScore.peakRatio } });

    return list;
}

/** What the field has in modes beyond the device's own; null where there are none. */
nlohmann::ordered_json spillOverJson (const RenderedFocus& focus)
{
    nlohmann::ordered_json spill;
    const auto hasBeyond = focus.model.modes() > focus.known.modes() && focus.design.description.fingers.empty();
    spill["share"] = hasBeyond ? nlohmann::ordered_json (spillOverShare (focus)) : nlohmann::ordered_json();
    spill["device_modes"] = focus.known.modes();
    spill["highest_frequency_Hz"] = focus.model.frequencyHz (focus.model.modes() - 1);

    if (const auto& made = focus.design.spillOver)
    {
        spill["designed_frequency_Hz"] = made->designedFrequency;
        spill["guarded_beyond"] = made->guardedBeyond;
        spill["share_unguarded"] = made->unguardedShare;
        spill["peak_voltage_unguarded_V"] = made->guardedBeyond > 0 ? made->unguardedPeak : peakVoltage (focus.design);
    }

    spill["sentence"] = spillOverInWords (focus);
    return spill;
}

nlohmann::ordered_json probesJson (const RenderedFocus& focus)
{
    auto list = nlohmann::ordered_json::array();

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
    {
        const auto velocity = focus.render.probeVelocities.row (static_cast<Eigen::Index> (i));
        const auto peak = largestInTime (velocity);
        list.push_back ({ { "x_mm", focus.probes[i].first * 1000 },
                          { "y_mm", focus.probes[i].second * 1000 },
                          { "velocity_at_focus_mm_s", velocity[focus.render.focusSample] * 1000 },
                          { "peak_velocity_mm_s", peak.value * 1000 },
                          { "peak_time_ms", peak.position / focus.render.sampleRate * 1000 } });
    }

    return list;
}

nlohmann::ordered_json limitJson (const ModalModel& model, const LimitUse& limit)
{
    return { { "kind", wordFor (limitKindWords, limit.kind) },
             { "is_reached", isReached (limit) },
             { "ceramic", model.ceramics[static_cast<std::size_t> (limit.ceramic)].name },
             { "time_after_focus_ms", limit.time * 1000 },
             { "used_share", limit.share() },
             { "used", limitAmount (limit.kind, limit.used) },
             { "allowed", limitAmount (limit.kind, limit.allowed) },
             { "sentence", limitSentence (model, limit) } };
}

nlohmann::ordered_json placeJson (const FieldPeak& peak)
{
    return { peak.x * milli, peak.y * milli };
}

nlohmann::ordered_json widthJson (const std::optional<double>& width)
{
    return width ? nlohmann::ordered_json (*width * milli) : nlohmann::ordered_json();
}

nlohmann::ordered_json targetsJson (const FocusOutcome& outcome)
{
    auto list = nlohmann::ordered_json::array();

    for (const auto& target : outcome.targets)
        list.push_back (
            { { "time_ms", target.time * milli },
              { "wanted_place_mm", { target.wanted.x * milli, target.wanted.y * milli } },
              { "place_mm", placeJson (target.peak) },
              { "wanted_velocity_mm_s", target.wanted.phase * target.wanted.peakVelocity * milli },
              { "velocity_mm_s", target.peak.velocity * milli },
              { "velocity_at_wanted_place_mm_s", target.velocityAtCentre * milli },
              { "wanted_width_mm",
                { target.wanted.width * milli, target.wanted.widthY.value_or (target.wanted.width) * milli } },
              { "width_mm", { widthJson (target.width), widthJson (target.widthY) } } });

    return list;
}

/** Against the wanted field, against its represented part, and what to expect on the device itself. */
void addScores (nlohmann::ordered_json& summary, const RenderedFocus& focus,
                const std::optional<ExpectedError>& expected)
{
    summary["v_score"] = focus.score.vScore;
    summary["field_error"] = focus.score.fieldError;
    summary["peak_ratio"] = focus.score.peakRatio;
    summary["v_score_truncated"] = focus.truncatedScore.vScore;
    summary["field_error_truncated"] = focus.truncatedScore.fieldError;
    summary["peak_ratio_truncated"] = focus.truncatedScore.peakRatio;

    if (expected)
        summary["expected_field_error"] = { { "median", expected->median },
                                            { "one_of_ten_above", expected->high },
                                            { "sentence", expected->sentence } };
}
} // namespace

nlohmann::ordered_json summaryToJson (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    const auto& design = focus.design;
    const auto& certificate = design.certificate;
    nlohmann::ordered_json summary;
    summary["device"] = focus.model.name;
    summary["focus"] = design.description.name;
    summary["sample_rate_Hz"] = focus.render.sampleRate;
    summary["reconstruction"] =
        design.playback.reconstruction == Reconstruction::bandLimited ? "band_limited" : "zero_order_hold";
    summary["ceramics"] = focus.model.actuators();
    summary["modes_controlled"] = design.controlledModes.size();
    summary["modes_simulated"] = focus.model.modes();
    summary["spill_over"] = spillOverJson (focus);
    summary["captured"] = design.captured;
    summary["residue"] = design.residue;
    addScores (summary, focus, outcome.expected);
    summary["contrast"] = focus.contrast;
    summary["focus_time_ms"] = static_cast<double> (focus.render.focusSample) / focus.render.sampleRate * 1000;
    summary["foci"] = fociJson (focus);
    summary["peak_velocity_mm_s"] = std::abs (focus.moments.front().peak.velocity) * 1000;
    summary["peak_place_mm"] = placeJson (focus.moments.front().peak);
    summary["targets"] = targetsJson (outcome);
    summary["side_lobe"] = std::abs (outcome.sideLobe.velocity / focus.moments.front().peak.velocity);
    summary["side_lobe_place_mm"] = placeJson (outcome.sideLobe);
    summary["side_lobe_wanted"] = outcome.wantedSideLobe;
    summary["elsewhere_velocity_mm_s"] = std::abs (outcome.elsewhere.velocity) * milli;
    summary["elsewhere_place_mm"] = placeJson (outcome.elsewhere);
    summary["elsewhere_time_ms"] = outcome.elsewhere.time * milli;
    summary["event_contrast"] = outcome.eventContrast;
    summary["field_limit"] = outcome.limit;
    summary["peak_voltage_V"] = focus.render.voltages.cwiseAbs().maxCoeff();
    summary["voltage_limit_V"] = design.program.voltageLimits.maxCoeff();
    summary["full_scale_V"] = focus.model.fullScaleVoltage;

    if (design.limit)
        summary["limit"] = limitJson (focus.model, *design.limit);

    summary["lower_bound_voltage_V"] = design.lowerBoundVoltage;
    summary["lower_bound_gap"] = design.lowerBoundGap;

    if (design.program.samples)
        summary["intersample_peak_voltage_V"] = design.intersamplePeakVoltage;

    if (focus.residual)
    {
        summary["residual_field_ratio"] = focus.residual->ratio;
        summary["residual_time_ms"] = focus.residual->time * 1000;
    }

    if (design.shortestPeriod)
        summary["shortest_period_ms"] = *design.shortestPeriod * 1000;

    summary["limited_samples"] = focus.render.limitedSamples;

    if (focus.undone)
        summary["lag"] = lagJson (*focus.undone);

    summary["allocation"] = wordFor (allocationMethodWords, design.description.allocation.method);
    summary["solver"] = { { "status", wordFor (allocationStatusWords, certificate.status) },
                          { "iterations", certificate.iterations },
                          { "gap", certificate.gap },
                          { "time_ms", certificate.milliseconds } };
    summary["probes"] = probesJson (focus);
    summary["warnings"] = design.warnings;

    if (! design.description.fingers.empty())
        summary["fingers"] = fingersToJson (focus);

    if (focus.felt)
        summary["felt"] = feltToJson (*focus.felt);

    if (focus.power)
        summary["power"] = powerToJson (focus.model, *focus.power);

    return summary;
}

namespace
{
FingerMotion motionUnder (const RenderedFocus& focus, const Finger& finger)
{
    const Eigen::RowVectorXd velocity = contactShapes (focus.model, finger) * focus.render.modalVelocities;
    const auto peak = largestInTime (velocity);
    return { finger, velocity[focus.render.focusSample], peak.value, peak.position / focus.render.sampleRate };
}
std::string contactInWords (const std::optional<ContactHistory>& contact)
{
    return contact ? "; lifted off " + std::to_string (contact->lifts) + (contact->lifts == 1 ? " time, " : " times, ")
                         + inWords (contact->liftedTime * milli) + " ms in all"
                   : std::string {};
}
} // namespace

std::vector<FingerMotion> fingerMotions (const RenderedFocus& focus)
{
    const auto& fingers = focus.design.description.fingers;
    std::vector<FingerMotion> motions;
    std::transform (fingers.begin(), fingers.end(), std::back_inserter (motions),
                    [&] (const auto& finger) { return motionUnder (focus, finger); });

    for (std::size_t i = 0; i < focus.contacts.size(); ++i)
        motions[i].contact = focus.contacts[i];

    return motions;
}

std::vector<std::string> fingersToText (const RenderedFocus& focus)
{
    std::vector<std::string> lines;

    for (const auto& motion : fingerMotions (focus))
        lines.push_back (
            formatted ("%-14s %s at %s%s: %s mm/s at the focus, %s mm/s at most, %s ms after the trigger%s",
                       ("finger " + std::to_string (lines.size() + 1)).c_str(), motion.finger.name.c_str(),
                       placeInWords (focus.model.surface, motion.finger.x, motion.finger.y).c_str(),
                       motion.finger.isKnown ? "" : ", unknown to the design",
                       inWords (motion.velocityAtFocus * milli).c_str(), inWords (motion.peakVelocity * milli).c_str(),
                       inWords (motion.peakTime * milli).c_str(), contactInWords (motion.contact).c_str()));

    return lines;
}

nlohmann::ordered_json fingersToJson (const RenderedFocus& focus)
{
    auto list = nlohmann::ordered_json::array();

    for (const auto& motion : fingerMotions (focus))
    {
        list.push_back ({ { "x_mm", motion.finger.x * milli },
                          { "y_mm", motion.finger.y * milli },
                          { "kind", motion.finger.name },
                          { "known", motion.finger.isKnown },
                          { "velocity_at_focus_mm_s", motion.velocityAtFocus * milli },
                          { "peak_velocity_mm_s", motion.peakVelocity * milli },
                          { "peak_time_ms", motion.peakTime * milli } });

        if (motion.contact)
        {
            list.back()["lifts"] = motion.contact->lifts;
            list.back()["lifted_ms"] = motion.contact->liftedTime * milli;
        }
    }

    return list;
}
} // namespace antinode
