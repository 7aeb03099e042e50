#include "PerformedWaveforms.h"

#include "FocusOutcome.h"
#include "PlayedTracks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_focus/Projection.h>
#include <antinode_focus/TargetField.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_tracks/LiveTracks.h>
#include <antinode_tracks/TrackWork.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double listening = 0.3; // s that the surface is listened to after the last voltage

/** What a finger feels that moves: what it rides on, with its last 50 ms faded out, since the surface still rings. */
double levelOnPath (const PlayedTracks& played, Eigen::Index point, const SkinThreshold& threshold)
{
    constexpr double fading = 0.05; // s
    Eigen::VectorXd ridden = played.displacements.row (point).transpose();
    const auto count = std::min (ridden.size(), static_cast<Eigen::Index> (fading * played.sampleRate));

    for (Eigen::Index n = 0; n < count; ++n)
        ridden[ridden.size() - 1 - n] *=
            0.5 - 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (count));

    return sensationLevel (feltAmount (feltDisplacement (ridden, played.sampleRate, threshold), played.sampleRate));
}

FeltOutcome feltByFingers (const PerformedWaveforms& performed, const SkinThreshold& threshold)
{
    Render render;
    render.sampleRate = performed.played.modalRate;
    render.modalVelocities = performed.played.modalVelocities;
    std::vector<Target> places;

    const auto points = touchedPoints (performed.design.description);

    for (const auto& point : points)
    {
        Target place;
        place.x = point.x;
        place.y = point.y;
        places.push_back (place);
    }

    auto felt = feltOutcome (performed.judge, render, places, threshold);

    for (std::size_t p = 0; p < points.size(); ++p)
        if (! points[p].path.empty())
            felt.targets[p].level = levelOnPath (performed.played, static_cast<Eigen::Index> (p), threshold);

    return felt;
}

/** The surface with its fingers, which plays the voltages of a design. */
void play (PerformedWaveforms& performed, const ModalModel& judge)
{
    const auto fingers = restingFingers (performed.design.description);
    performed.judge = fingers.empty() ? judge : loadedModel (judge, fingers);
    const auto& voltages = performed.design.voltages;
    performed.played = playTracks (performed.judge, performed.design.description, voltages, listening);
    performed.power = focusPower (judge, voltages.values, voltages.playback,
                                  voltages.playback.sampleRate / static_cast<double> (voltages.values.cols()));
}

void score (PerformedWaveforms& performed, const SkinThreshold& threshold)
{
    const auto& design = performed.design;
    performed.scores = scoreTracks (performed.played, design.wanted, design.description.band);
    performed.felt = feltByFingers (performed, threshold);
}

/** What the voltages do on devices that the surface may stand for: mean energies. */
std::vector<double> expectedSuppression (const PerformedWaveforms& performed, const ModalModel& judge)
{
    constexpr std::size_t draws = 4;
    const auto& design = performed.design;
    const auto fingers = restingFingers (design.description);
    const std::function<TrackScores (std::size_t)> scoreOn = [&] (std::size_t number)
    {
        const auto device = likelyDevice (judge, number);
        return scoreTracks (playTracks (fingers.empty() ? device : loadedModel (device, fingers), design.description,
                                        design.voltages, listening),
                            design.wanted, design.description.band);
    };
    const auto scores = evaluateCases (draws, scoreOn);
    std::vector<double> expected;

    for (std::size_t p = 0; p < performed.scores.fingers.size(); ++p)
    {
        double energy = 0;

        for (const auto& score : scores)
            energy += std::pow (10.0, score.suppression (p) / 10) / draws;

        expected.push_back (10 * std::log10 (energy));
    }

    return expected;
}

/** @throws InputError  for voltages that cannot be judged */
void requireJudgeable (const ModalModel& judge, const WaveformsDescription& description, double sampleRate,
                       const Eigen::MatrixXd& voltages)
{
    if (voltages.rows() != judge.actuators())
        throw InputError ("played voltages", "have " + std::to_string (voltages.rows())
                                                 + " channels; allowed: " + std::to_string (judge.actuators())
                                                 + ", one per ceramic of " + judge.name);

    for (const auto& point : touchedPoints (description))
        if (! point.path.empty())
            throw InputError ("waveforms", "have a path; allowed with played voltages: points that stay, since when "
                                           "tracks begin has to be found");

    constexpr double kept = 12000; // modal velocities per second: those of playTracks
    const auto seconds = static_cast<double> (voltages.cols()) / sampleRate;
    requireTrackMemory (
        { sizeof (double) * seconds
              * (kept * static_cast<double> (judge.coordinates()) + sampleRate * static_cast<double> (voltages.rows())),
          0 },
        seconds);
}

nlohmann::ordered_json pathJson (const std::vector<PathPoint>& path)
{
    auto json = nlohmann::ordered_json::array();

    for (const auto& corner : path)
        json.push_back (
            { { "time_ms", corner.time * milli }, { "x_mm", corner.x * milli }, { "y_mm", corner.y * milli } });

    return json;
}

nlohmann::ordered_json fingerJson (const PerformedWaveforms& performed, std::size_t p)
{
    const auto& description = performed.design.description;
    const auto points = touchedPoints (description);
    const auto& score = performed.scores.fingers[p];
    nlohmann::ordered_json json { { "name", fingerName (description, p) },
                                  { "place_mm", { points[p].x * milli, points[p].y * milli } },
                                  { "has_track", p < description.tracks.size() },
                                  { "wanted_peak_um", score.wantedPeak * micro },
                                  { "reached_peak_um", score.reachedPeak * micro },
                                  { "suppression_dB", performed.scores.suppression (p) },
                                  { "suppression_all_frequencies_dB", performed.scores.wideSuppression (p) } };

    if (! performed.expected.empty())
        json["expected_suppression_dB"] = performed.expected[p];

    if (! points[p].path.empty())
        json["path"] = pathJson (points[p].path);

    if (p < description.tracks.size())
        json["normalised_error"] = performed.scores.normalisedError (p);

    json["level_dB_SL"] = performed.felt.targets[p].level;
    return json;
}
} // namespace

PerformedWaveforms performDesigned (const ModalModel& judge, TrackDesign design, const SkinThreshold& threshold)
{
    PerformedWaveforms performed;
    performed.design = std::move (design);
    play (performed, judge);
    score (performed, threshold);
    const auto& voltages = performed.design.voltages;

    if (needsLagFilters (performed.judge))
        performed.undone = withLagsUndone (performed.judge, voltages.values, voltageLimits (performed.judge),
                                           voltages.playback.sampleRate);

    return performed;
}

PerformedWaveforms performWaveforms (const ModalModel& known, const ModalModel& judge,
                                     const WaveformsDescription& description, const TrackSettings& settings,
                                     const ShowProgress& progress, const std::vector<RecordedPass>& passes)
{
    std::optional<TrackCorrection> correction;

    if (! passes.empty())
        correction = correctionFrom (known, description, settings, passes);

    auto design = settings.latency > 0 ? designLiveTracks (known, description, settings, progress)
                                       : designTracks (known, description, settings, progress,
                                                       correction ? correction->shift : TrackShift {});

    if (correction)
        design.warnings.emplace_back ("Corrected for the recorded surface: on the simulated one, which equals its "
                                      "model, the errors are those that the correction compensates for.");

    if (correction && correction->errors[correction->best] >= 0)
        design.warnings.emplace_back ("The recording is no closer to the wanted motion than silence: check "
                                      "wiring, unit, sign and order of the channels.");

    if (progress)
        progress ("Playing", 0.8);

    auto performed = performDesigned (judge, std::move (design), settings.threshold);
    performed.correction = std::move (correction);

    if (progress)
        progress ("What to expect of the device", 0.9);

    performed.expected = expectedSuppression (performed, judge);
    return performed;
}

PerformedWaveforms judgeVoltages (const ModalModel& known, const ModalModel& judge,
                                  const WaveformsDescription& description, const TrackSettings& settings,
                                  const Eigen::MatrixXd& voltages, const ShowProgress& progress)
{
    constexpr double alike = 0.9;
    requireJudgeable (judge, description, settings.sampleRate, voltages);
    PerformedWaveforms performed;
    auto& design = performed.design;
    design.description = description;
    design.warnings = description.warnings;
    design.wanted = wantedAsPlayed (known, description, settings);
    design.designRate = settings.sampleRate;
    design.voltages = { { Reconstruction::bandLimited, settings.sampleRate }, 0, voltages };
    design.peaks = voltages.cwiseAbs().rowwise().maxCoeff();
    design.limitUse.unlimitedPeak = design.peaks.cwiseQuotient (voltageLimits (judge)).maxCoeff();

    if (progress)
        progress ("Playing", 0.3);

    play (performed, judge);
    const auto alignment = alignTracks (performed.played.displacements, design.wanted);
    performed.likeness = alignment.likeness;
    performed.played.trigger = alignment.begin;
    design.voltages.firstTime = -static_cast<double> (alignment.begin) / settings.sampleRate;

    if (alignment.likeness < alike)
        design.warnings.push_back ("The motion at the fingers does not resemble the tracks (correlation "
                                   + fixedText (alignment.likeness, 2)
                                   + "): check order, sign and scale of the channels, places and band.");

    score (performed, settings.threshold);
    return performed;
}

const Eigen::MatrixXd& outputVoltages (const PerformedWaveforms& performed)
{
    return performed.undone ? performed.undone->voltages : performed.design.voltages.values;
}

std::string fingerName (const WaveformsDescription& description, std::size_t point)
{
    const auto name = touchedPoints (description)[point].name;
    return name.empty() ? pointInWords (description, point) : name;
}

std::string trackVoltsInWords (const PerformedWaveforms& performed)
{
    const auto& design = performed.design;
    Eigen::Index ceramic = 0;
    const auto peak = design.peaks.maxCoeff (&ceramic);
    const auto& use = design.limitUse;
    auto text = inWords (peak) + " V at ceramic " + std::to_string (ceramic + 1) + ", "
                + inWords (100 * peak / voltageLimits (performed.judge)[ceramic]) + " % of its limit";

    if (use.unlimitedPeak <= 1)
        return text;

    return text + "; without limits the least-norm voltages would have " + inWords (use.unlimitedPeak)
           + " times the limits, and none of any form reach this error with less than " + inWords (use.peakBound)
           + " times";
}

nlohmann::ordered_json performedToJson (const PerformedWaveforms& performed)
{
    const auto& design = performed.design;
    nlohmann::ordered_json json { { "schema", "antinode.performance/1" },
                                  { "waveforms", design.description.name },
                                  { "device", performed.judge.name },
                                  { "sample_rate_Hz", design.voltages.playback.sampleRate },
                                  { "trigger_sample",
                                    performed.played.trigger + (performed.undone ? performed.undone->lateness : 0) },
                                  { "modes", performed.judge.modes() },
                                  { "peak_voltage_V", design.peaks.maxCoeff() },
                                  { "unlimited_peak_over_limit", design.limitUse.unlimitedPeak } };

    if (performed.likeness)
        json["likeness"] = *performed.likeness;
    else
        json.update ({ { "design_error", design.error }, { "iterations", design.iterations } });

    if (performed.undone)
        json["lag"] = lagJson (*performed.undone);

    if (design.latency > 0)
        json["latency_ms"] = design.latency * milli;

    if (design.limitUse.unlimitedPeak > 1)
        json["peak_bound_over_limit"] = design.limitUse.peakBound;

    if (const auto& correction = performed.correction)
    {
        auto latencies = correction->latencies;

        for (auto& latency : latencies)
            latency *= milli;

        json["passes"] = { { "errors_dB", correction->errors },
                           { "latencies_ms", latencies },
                           { "best", correction->best + 1 },
                           { "corrected_share", correction->gain } };
    }

    json["fingers"] = nlohmann::ordered_json::array();

    for (std::size_t p = 0; p < performed.scores.fingers.size(); ++p)
        json["fingers"].push_back (fingerJson (performed, p));

    if (performed.tolerance)
        json["tolerance"] = toleranceToJson (design.description, *performed.tolerance);

    json["felt_share"] = performed.felt.feltShare;
    json["threshold"] = performed.felt.threshold;
    json["power"] = powerToJson (performed.judge, performed.power);
    json["warnings"] = design.warnings;
    return json;
}

namespace
{
constexpr double longest = 60;     // s, of a focus in a file
constexpr double spotWidth = 0.02; // m: about a fingertip

/** When and where the wanted motion is fastest. */
struct FastestMotion
{
    Eigen::Index sample = 0;
    std::size_t track = 0;
    double velocity = 0; // m/s
};

FastestMotion fastestMotion (const TrackDesign& design)
{
    FastestMotion fastest;
    const auto& wanted = design.wanted;
    const auto tracks = static_cast<Eigen::Index> (design.description.tracks.size());

    for (Eigen::Index p = 0; p < tracks; ++p)
        for (Eigen::Index n = 1; n + 1 < wanted.rows(); ++n)
        {
            const auto velocity = (wanted (n + 1, p) - wanted (n - 1, p)) / 2 * design.voltages.playback.sampleRate;

            if (std::abs (velocity) > std::abs (fastest.velocity))
                fastest = { n, static_cast<std::size_t> (p), velocity };
        }

    return fastest;
}

FocusDescription describedFocus (const PerformedWaveforms& performed)
{
    const auto& design = performed.design;
    const auto& waveforms = design.description;
    const auto fastest = fastestMotion (design);
    const auto time = static_cast<double> (fastest.sample) / design.voltages.playback.sampleRate;
    const auto at = placeAt (waveforms.tracks[fastest.track].point, time);
    FocusDescription focus;
    focus.name = waveforms.name;
    focus.focusTime = time - design.voltages.firstTime;
    focus.targets.push_back (
        { TargetShape::bump, at.x, at.y, spotWidth, std::abs (fastest.velocity), fastest.velocity < 0 ? -1 : 1 });
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = upToLimits;

    for (const auto& point : touchedPoints (waveforms))
    {
        focus.probes.emplace_back (point.x, point.y);

        if (point.finger)
        {
            focus.fingers.push_back (*point.finger);
            focus.fingers.back().isKnown = false;
        }
    }

    if (focus.focusTime > longest)
        throw InputError ("waveforms", "have their fastest motion " + inWords (focus.focusTime)
                                           + " s after the first sample; allowed in a design: " + inWords (longest)
                                           + " s");

    return focus;
}

/** The modes of the band; the lowest at least. */
std::vector<int> modesOfBand (const ModalModel& model, const TrackBand& band)
{
    std::vector<int> modes { 0 };

    for (int k = 1; k < static_cast<int> (model.modes()) && model.frequencyHz (k) <= band.upper; ++k)
        modes.push_back (k);

    return modes;
}

void addMoments (FocusDesign& design, const ModalModel& model)
{
    design.moments = focusMoments (model, design.description, design.playback);
    auto& moment = design.moments.front();
    auto represented = restrictToModes (model, moment.target, design.controlledModes);
    moment.wanted = std::move (represented.wanted);
    moment.truncatedField = std::move (represented.truncated);
    moment.captured = represented.captured;
    design.target = moment.target;
    design.truncatedField = moment.truncatedField;
    design.captured = moment.captured;
    design.residue = std::sqrt (std::max (0.0, 1 - moment.captured * moment.captured));
}
} // namespace

FocusDesign performedDesign (const PerformedWaveforms& performed, const ModalModel& own)
{
    const auto& made = performed.design;
    FocusDesign design;
    design.description = describedFocus (performed);
    design.playback = made.voltages.playback;
    design.controlledModes = modesOfBand (own, made.description.band);
    design.growth.assign (design.controlledModes.size(), 0.0);
    design.cycles.assign (design.controlledModes.size(), 0);
    addMoments (design, own);
    design.program.focusTime = design.description.focusTime;
    design.program.voltageLimits = voltageLimits (own);
    design.program.allocation.resize (own.actuators(), 0);
    design.program.samples = made.voltages;
    design.program.samples->firstTime = 0;
    design.certificate.peakVoltage = made.peaks.maxCoeff();
    design.certificate.peakRatio = made.peaks.cwiseQuotient (design.program.voltageLimits).maxCoeff();
    design.reachablePeakVelocity = design.description.targets.front().peakVelocity;
    design.choices.push_back ("Voltages of waveforms at fingers, from their first sample on. The target represents the "
                              "fastest wanted motion of a track; scores against it do not apply to the waveforms.");
    design.warnings = made.warnings;
    return design;
}
} // namespace antinode
