#include "DesignFile.h"

#include "FileUnits.h"
#include "FocusFile.h"
#include "FocusWords.h"

#include <antinode_focus/LimitWords.h>
#include <antinode_text/EigenJson.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
using Json = nlohmann::ordered_json;

Json conventions()
{
    return {
        { "mode", "number of the device's flexible mode, the lowest is 1" },
        { "time", "seconds from the trigger" },
        { "oscillation", "value(t) = exp(growth_per_s tau) (in_phase sin(2 pi frequency_Hz tau) + quadrature cos(2 pi "
                         "frequency_Hz tau)), "
                         "tau = t - start_s, for start_s <= t < end_s, else 0" },
        { "angular_frequency_rad_s", "2 pi frequency_Hz to the last bit" },
        { "free_decay_per_s", "of a brake: the free decay rate of its mode" },
        { "counter_share",
          "of a brake: real and imaginary part of the fraction of its effect on its mode that rotates against it" },
        { "allocation",
          "one row per ceramic, one column per oscillation: U_i(t) = sum over c of allocation[i][c] value_c(t), in V" },
        { "samples",
          "of a free waveform: one row per ceramic, the first sample at first_time_s; added to the voltages of "
          "oscillations and allocation, if any" }
    };
}

Json oscillationToJson (const Oscillation& oscillation)
{
    Json json { { "mode", oscillation.mode + 1 },
                { "start_s", oscillation.start },
                { "end_s", oscillation.end },
                { "growth_per_s", oscillation.growth },
                { "frequency_Hz", toHertz (oscillation.angularFrequency) },
                { "angular_frequency_rad_s", oscillation.angularFrequency },
                { "in_phase", oscillation.inPhase },
                { "quadrature", oscillation.quadrature } };

    if (oscillation.isBrake())
    {
        json["free_decay_per_s"] = oscillation.freeDecay;
        json["counter_share"] = { oscillation.counterShare.real(), oscillation.counterShare.imag() };
    }

    return json;
}

Json playbackToJson (const Playback& playback)
{
    const auto isBandLimited = playback.reconstruction == Reconstruction::bandLimited;
    return { { "reconstruction", isBandLimited ? "band_limited" : "zero_order_hold" },
             { "sample_rate_Hz", playback.sampleRate } };
}

Json samplesToJson (const SampledVoltages& samples)
{
    auto json = playbackToJson (samples.playback);
    json["first_time_s"] = samples.firstTime;
    json["voltages_V"] = toJsonRows (samples.values);
    return json;
}

Json controlledModesToJson (const FocusDesign& design, const ModalModel& model)
{
    auto list = Json::array();

    for (std::size_t i = 0; i < design.controlledModes.size(); ++i)
    {
        const auto k = design.controlledModes[i];
        list.push_back ({ { "mode", k + 1 },
                          { "frequency_Hz", model.frequencyHz (k) },
                          { "damping_ratio", model.dampingRatios[k] },
                          { "wanted_velocity_m_s_sqrt_kg", design.target.modalVelocities[k] },
                          { "growth", design.growth.at (i) },
                          { "cycles", design.cycles.at (i) } });
    }

    return list;
}

Json certificateToJson (const AllocationCertificate& certificate)
{
    return { { "status", wordFor (allocationStatusWords, certificate.status) },
             { "iterations", certificate.iterations },
             { "rounds", certificate.rounds },
             { "objective", certificate.objective },
             { "bound", certificate.bound },
             { "gap", certificate.gap },
             { "peak_ratio", certificate.peakRatio },
             { "peak_voltage_V", certificate.peakVoltage },
             { "least_peak_ratio", certificate.minimumPeakRatio },
             { "row_residual", certificate.rowResidual },
             { "time_ms", certificate.milliseconds } };
}

/** Of a train the foci after the first, whose field is the design's. */
Json laterFociToJson (const FocusDesign& design, const Surface& surface)
{
    const auto on = pointsOn (surface);
    auto list = Json::array();

    for (std::size_t i = 1; i < design.moments.size(); ++i)
    {
        const auto& moment = design.moments[i];
        list.push_back ({ { "time_s", moment.time },
                          { "captured", moment.captured },
                          { "wanted_velocities_m_s_sqrt_kg", toJsonList (moment.wanted) },
                          { "wanted_mm_s", toJsonList (moment.target.field (on) * 1000) },
                          { "truncated_mm_s", toJsonList (moment.truncatedField (on) * 1000) } });
    }

    return list;
}

Json fieldToJson (const FocusDesign& design, const ModalModel& model)
{
    constexpr double millimetres = 1000;
    const auto on = pointsOn (model.surface);
    return { { "x_mm", toJsonList (model.surface.points (on, 0) * millimetres) },
             { "y_mm", toJsonList (model.surface.points (on, 1) * millimetres) },
             { "wanted_mm_s", toJsonList (design.target.field (on) * millimetres) },
             { "truncated_mm_s", toJsonList (design.truncatedField (on) * millimetres) } };
}
} // namespace

nlohmann::ordered_json designToJson (const FocusDesign& design, const ModalModel& model)
{
    Json json { { "schema", "antinode.design/1" }, { "device", model.name }, { "conventions", conventions() } };
    json["focus"] = focusToJson (design.description);
    json["focus_time_s"] = design.program.focusTime;
    json["captured"] = design.captured;
    json["residue"] = design.residue;
    json["controlled_modes"] = controlledModesToJson (design, model);

    if (! design.program.samples || ! design.program.oscillations.empty())
    {
        json["oscillations"] = Json::array();

        for (const auto& oscillation : design.program.oscillations)
            json["oscillations"].push_back (oscillationToJson (oscillation));
    }

    json["ceramics"] = Json::array();

    for (const auto& ceramic : model.ceramics)
        json["ceramics"].push_back (ceramic.name);

    json["voltage_limits_V"] = toJsonList (design.program.voltageLimits);

    if (json.contains ("oscillations"))
        json["allocation"] = toJsonRows (design.program.allocation);

    if (design.program.samples)
    {
        json["samples"] = samplesToJson (*design.program.samples);
        json["intersample_peak_voltage_V"] = design.intersamplePeakVoltage;
    }

    json["certificate"] = certificateToJson (design.certificate);
    json["least_peak_voltage_V"] = design.minimumPeakVoltage;
    json["reachable_peak_velocity_mm_s"] = toMillimetres (design.reachablePeakVelocity);

    if (design.limit)
        json["limit"] = limitSentence (model, *design.limit);

    json["lower_bound_voltage_V"] = design.lowerBoundVoltage;
    json["lower_bound_gap"] = design.lowerBoundGap;

    if (design.restTime)
        json["rest_time_ms"] = toMilliseconds (*design.restTime);

    if (design.shortestPeriod)
        json["shortest_period_ms"] = toMilliseconds (*design.shortestPeriod);

    json["playback"] = playbackToJson (design.playback);
    json["choices"] = design.choices;
    json["warnings"] = design.warnings;
    json["field"] = fieldToJson (design, model);

    if (design.moments.size() > 1)
        json["later_foci"] = laterFociToJson (design, model.surface);

    return json;
}
} // namespace antinode
