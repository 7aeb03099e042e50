#include "RenderedFocus.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/FocusWords.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_focus/TargetField.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double minimumAftermath = 0.025; // s
constexpr double residualSpan = 0.002;     // s: a velocity that passes through zero just then is no rest

double defaultDuration (const FocusDesign& design)
{
    const auto focus = design.moments.back().time;
    auto end = std::max (2 * focus, focus + minimumAftermath);

    for (const auto& oscillation : design.program.oscillations)
        end = std::max (end, oscillation.end);

    return design.restTime ? std::max (end, focus + *design.restTime + 1.5 * residualSpan) : end;
}

ReachedMoment reachedAt (const ModalModel& model, const FocusMoment& moment, const Render& render, std::int64_t sample)
{
    ReachedMoment reached;
    reached.sample = sample;
    reached.modalVelocities = render.modalVelocities.col (sample);
    reached.field = model.shapes * reached.modalVelocities;
    reached.score = scoreField (model.surface, reached.field, moment.target.field);
    reached.truncatedScore = scoreField (model.surface, reached.field, moment.truncatedField);
    return reached;
}

/** Later foci fall on samples counted from the first. */
std::vector<ReachedMoment> reachedMoments (const ModalModel& model, const FocusDesign& design, const Render& render)
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

        reached.push_back (reachedAt (model, moment, render, sample));
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

    const Eigen::MatrixXd left = focus.model.shapes * render.modalVelocities.middleCols (first, count);
    return ResidualMotion { *focus.design.restTime,
                            left.cwiseAbs().maxCoeff() / focus.moments.back().field.cwiseAbs().maxCoeff() };
}

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

nlohmann::ordered_json probesJson (const RenderedFocus& focus)
{
    auto list = nlohmann::ordered_json::array();

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
    {
        const auto velocity = focus.render.probeVelocities.row (static_cast<Eigen::Index> (i));
        Eigen::Index peak = 0;
        velocity.cwiseAbs().maxCoeff (&peak);
        list.push_back ({ { "x_mm", focus.probes[i].first * 1000 },
                          { "y_mm", focus.probes[i].second * 1000 },
                          { "velocity_at_focus_mm_s", velocity[focus.render.focusSample] * 1000 },
                          { "peak_velocity_mm_s", velocity[peak] * 1000 },
                          { "peak_time_ms", static_cast<double> (peak) / focus.render.sampleRate * 1000 } });
    }

    return list;
}
} // namespace

RenderedFocus renderFocus (ModalModel model, FocusDesign design, const RenderOptions& options,
                           const std::function<void (double)>& progress)
{
    RenderedFocus result;
    result.probes = chooseProbes (design, options);

    RenderSettings settings;
    settings.playback = options.playback;
    settings.duration = options.duration.value_or (defaultDuration (design));
    settings.blockSize = options.blockSize;
    settings.probeShapes.resize (static_cast<Eigen::Index> (result.probes.size()), model.modes());

    for (std::size_t i = 0; i < result.probes.size(); ++i)
        settings.probeShapes.row (static_cast<Eigen::Index> (i)) =
            shapesAt (model, result.probes[i].first, result.probes[i].second);

    result.render = renderOffline (model, design.program, settings, progress);
    result.moments = reachedMoments (model, design, result.render);
    result.reachedField = result.moments.front().field;
    result.score = result.moments.front().score;
    result.truncatedScore = result.moments.front().truncatedScore;
    result.contrast = fieldContrast (model.surface, result.reachedField, design.moments.front().targets);
    result.model = std::move (model);
    result.design = std::move (design);
    result.residual = residualMotion (result);
    return result;
}

nlohmann::ordered_json summaryToJson (const RenderedFocus& focus)
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
    summary["captured"] = design.captured;
    summary["residue"] = design.residue;
    summary["v_score"] = focus.score.vScore;
    summary["field_error"] = focus.score.fieldError;
    summary["peak_ratio"] = focus.score.peakRatio;
    summary["v_score_truncated"] = focus.truncatedScore.vScore;
    summary["field_error_truncated"] = focus.truncatedScore.fieldError;
    summary["peak_ratio_truncated"] = focus.truncatedScore.peakRatio;
    summary["contrast"] = focus.contrast;
    summary["focus_time_ms"] = static_cast<double> (focus.render.focusSample) / focus.render.sampleRate * 1000;
    summary["foci"] = fociJson (focus);
    summary["peak_velocity_mm_s"] = focus.reachedField.cwiseAbs().maxCoeff() * 1000;
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
    summary["allocation"] = wordFor (allocationMethodWords, design.description.allocation.method);
    summary["solver"] = { { "status", wordFor (allocationStatusWords, certificate.status) },
                          { "iterations", certificate.iterations },
                          { "gap", certificate.gap },
                          { "time_ms", certificate.milliseconds } };
    summary["probes"] = probesJson (focus);
    summary["warnings"] = design.warnings;
    return summary;
}
} // namespace antinode
