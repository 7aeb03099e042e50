#include "DesignFile.h"

#include "FileUnits.h"
#include "FocusFile.h"

#include <antinode_base/MessageText.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_focus/Projection.h>
#include <antinode_focus/TargetField.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

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

namespace
{
constexpr NumberRange anyNumber { -1e15, 1e15 };
constexpr NumberRange notNegative { 0, 1e15 };
constexpr NumberRange cycleRange { 0, 1e6 };
constexpr NumberRange seconds { -60, 600 };
constexpr NumberRange sampleRates { 1, 1e8 };
constexpr std::size_t mostOscillations = 1000000, mostSamples = 100000000;
constexpr std::size_t longestSentence = 10000, mostSentences = 1000;
constexpr int mostIterations = 1000000000;
constexpr double sameFrequency = 1e-6; // relative: what solving a device again may change

constexpr WordList<Reconstruction, 2> reconstructionWords { { { "band_limited", Reconstruction::bandLimited },
                                                              { "zero_order_hold", Reconstruction::zeroOrderHold } } };

JsonObject designObject (const JsonValue& value)
{
    value.requireSchema ("antinode.design/1");
    return value.object ({ "schema",
                           "device",
                           "conventions",
                           "focus",
                           "focus_time_s",
                           "captured",
                           "residue",
                           "controlled_modes",
                           "oscillations",
                           "ceramics",
                           "voltage_limits_V",
                           "allocation",
                           "samples",
                           "intersample_peak_voltage_V",
                           "certificate",
                           "least_peak_voltage_V",
                           "reachable_peak_velocity_mm_s",
                           "limit",
                           "lower_bound_voltage_V",
                           "lower_bound_gap",
                           "rest_time_ms",
                           "shortest_period_ms",
                           "playback",
                           "choices",
                           "warnings",
                           "field",
                           "later_foci",
                           "power" });
}

Eigen::VectorXd readVector (const JsonValue& value, Eigen::Index size, const NumberRange& range = anyNumber)
{
    const auto numbers = value.numbers (static_cast<std::size_t> (size), static_cast<std::size_t> (size), range);
    return Eigen::Map<const Eigen::VectorXd> (numbers.data(), size);
}

/** One row per ceramic, all equally long. */
Eigen::MatrixXd readRows (const JsonValue& value, Eigen::Index rows, std::size_t fewest, std::size_t most)
{
    const auto items = value.items (static_cast<std::size_t> (rows), static_cast<std::size_t> (rows));
    const auto columns = static_cast<Eigen::Index> (items.front().numbers (fewest, most, anyNumber).size());
    Eigen::MatrixXd matrix (rows, columns);

    for (Eigen::Index i = 0; i < rows; ++i)
        matrix.row (i) = readVector (items[static_cast<std::size_t> (i)], columns).transpose();

    return matrix;
}

std::vector<std::string> readSentences (const JsonValue& value)
{
    std::vector<std::string> sentences;

    for (const auto& item : value.items (0, mostSentences))
        sentences.push_back (item.text (longestSentence));

    return sentences;
}

Playback readPlayback (const JsonValue& value)
{
    return { value.required ("reconstruction").choice (reconstructionWords),
             value.required ("sample_rate_Hz").number (sampleRates) };
}

Oscillation readOscillation (const JsonValue& value)
{
    const auto object =
        value.object ({ "mode", "start_s", "end_s", "growth_per_s", "frequency_Hz", "angular_frequency_rad_s",
                        "in_phase", "quadrature", "free_decay_per_s", "counter_share" });
    const auto number = [&] (const char* key, const NumberRange& range = anyNumber)
    { return object.required (key).number (range); };
    Oscillation oscillation;
    oscillation.mode = object.required ("mode").integer (1, static_cast<int> (ranges::maximumModes)) - 1;
    oscillation.start = number ("start_s", seconds);
    oscillation.end = number ("end_s", seconds);
    oscillation.growth = number ("growth_per_s");
    oscillation.angularFrequency = number ("angular_frequency_rad_s", notNegative);
    oscillation.inPhase = number ("in_phase");
    oscillation.quadrature = number ("quadrature");

    if (object.has ("free_decay_per_s"))
    {
        const auto share = object.required ("counter_share").numbers (2, 2, anyNumber);
        oscillation.freeDecay = number ("free_decay_per_s", notNegative);
        oscillation.counterShare = { share[0], share[1] };
    }

    return oscillation;
}

VoltageProgram readProgram (const JsonObject& object, const ModalModel& model)
{
    VoltageProgram program;
    program.focusTime = object.required ("focus_time_s").number (seconds);
    program.voltageLimits = readVector (object.required ("voltage_limits_V"), model.actuators(), ranges::voltage)
                                .cwiseMin (voltageLimits (model));
    program.allocation.resize (model.actuators(), 0);

    if (const auto oscillations = object.optional ("oscillations"))
    {
        for (const auto& oscillation : oscillations->items (0, mostOscillations))
            program.oscillations.push_back (readOscillation (oscillation));

        const auto count = program.oscillations.size();
        program.allocation = readRows (object.required ("allocation"), model.actuators(), count, count);
    }

    if (const auto samples = object.optional ("samples"))
        program.samples = { readPlayback (*samples), samples->required ("first_time_s").number (seconds),
                            readRows (samples->required ("voltages_V"), model.actuators(), 1, mostSamples) };
    else if (program.oscillations.empty())
        object.fail ("has neither 'oscillations' nor 'samples'; allowed: one of them or both");

    return program;
}

AllocationCertificate readCertificate (const JsonValue& value)
{
    const auto number = [&] (const char* key) { return value.required (key).number (anyNumber); };
    AllocationCertificate certificate;
    certificate.status = value.required ("status").choice (allocationStatusWords);
    certificate.iterations = value.required ("iterations").integer (0, mostIterations);
    certificate.rounds = value.required ("rounds").integer (0, mostIterations);
    certificate.objective = number ("objective");
    certificate.bound = number ("bound");
    certificate.gap = number ("gap");
    certificate.peakRatio = number ("peak_ratio");
    certificate.peakVoltage = number ("peak_voltage_V");
    certificate.minimumPeakRatio = number ("least_peak_ratio");
    certificate.rowResidual = number ("row_residual");
    certificate.milliseconds = number ("time_ms");
    return certificate;
}

/** A name may be the same where a device was changed: its modes say. */
void requireSameDevice (const JsonObject& object, const ModalModel& model)
{
    const auto device = object.required ("device");

    if (const auto name = device.text (ranges::maximumNameBytes); name != model.name)
        device.fail ("is '" + name + "', and it is to be played on '" + model.name
                     + "'; allowed: the device that it was made for");

    const auto ceramics = object.required ("ceramics").items (0, ranges::maximumCeramics);

    if (static_cast<Eigen::Index> (ceramics.size()) != model.actuators())
        object.required ("ceramics")
            .fail ("has " + std::to_string (ceramics.size()) + " ceramics; allowed: the "
                   + std::to_string (model.actuators()) + " of '" + model.name + "'");

    for (const auto& item : object.required ("controlled_modes").items (1, ranges::maximumModes))
    {
        const auto mode = item.required ("mode").integer (1, static_cast<int> (model.modes())) - 1;
        const auto frequency = item.required ("frequency_Hz").number (ranges::frequencyHz);

        if (std::abs (frequency / model.frequencyHz (mode) - 1) > sameFrequency)
            item.fail ("has " + inWords (frequency) + " Hz, and mode " + std::to_string (mode + 1) + " of '"
                       + model.name + "' has " + inWords (model.frequencyHz (mode))
                       + " Hz; allowed: the device that it was made for");
    }
}

void readControlledModes (FocusDesign& design, const JsonValue& value)
{
    for (const auto& item : value.items (1, ranges::maximumModes))
    {
        const auto mode = item.required ("mode").integer (1, static_cast<int> (ranges::maximumModes)) - 1;

        if (! design.controlledModes.empty() && mode <= design.controlledModes.back())
            item.fail ("has a mode that does not ascend; allowed: each mode once, the lowest first");

        design.controlledModes.push_back (mode);
        design.growth.push_back (item.required ("growth").number (anyNumber));
        design.cycles.push_back (static_cast<int> (item.required ("cycles").number (cycleRange)));
    }
}

/** What is wanted, and what the controlled modes represent of it, follow from the focus. */
void addMoments (FocusDesign& design, const JsonObject& object, const ModalModel& model)
{
    readControlledModes (design, object.required ("controlled_modes"));
    readVector (object.required ("field").required ("truncated_mm_s"), model.points());
    design.moments = focusMoments (model, design.description, design.playback);

    for (auto& moment : design.moments)
    {
        auto represented = restrictToModes (model, moment.target, design.controlledModes);
        moment.wanted = std::move (represented.wanted);
        moment.truncatedField = std::move (represented.truncated);
        moment.captured = represented.captured;
    }

    const auto& first = design.moments.front();
    design.target = first.target;
    design.truncatedField = first.truncatedField;
    design.captured = first.captured;
}
} // namespace

bool isDesignFile (const nlohmann::json& document)
{
    const auto schema = document.is_object() ? document.find ("schema") : document.end();
    return schema != document.end() && schema->is_string()
           && schema->get_ref<const std::string&>().starts_with ("antinode.design/");
}

DesignOrigin readDesignOrigin (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    const auto object = designObject (value);
    object.required ("focus");
    return { object.required ("device").text (ranges::maximumNameBytes), readPlayback (object.required ("playback")),
             object.has ("samples"), readFocus (document["focus"], source + " /focus") };
}

FocusDesign readDesign (const nlohmann::json& document, const std::string& source, const ModalModel& model)
{
    const JsonValue value (document, source);
    const auto object = designObject (value);
    requireSameDevice (object, model);
    const auto origin = readDesignOrigin (document, source);
    const auto number = [&] (const char* key) { return object.required (key).number (notNegative); };
    FocusDesign design;
    design.description = origin.focus;
    design.playback = origin.playback;
    addMoments (design, object, model);
    design.residue = number ("residue");
    design.program = readProgram (object, model);
    design.certificate = readCertificate (object.required ("certificate"));
    design.minimumPeakVoltage = number ("least_peak_voltage_V");
    design.reachablePeakVelocity = fromMillimetres (number ("reachable_peak_velocity_mm_s"));
    design.lowerBoundVoltage = number ("lower_bound_voltage_V");
    design.lowerBoundGap = number ("lower_bound_gap");
    design.limit = limitUses (model, design.description.allocation, design.program).nearest();

    if (object.has ("intersample_peak_voltage_V"))
        design.intersamplePeakVoltage = number ("intersample_peak_voltage_V");

    if (object.has ("rest_time_ms"))
        design.restTime = fromMilliseconds (number ("rest_time_ms"));

    if (object.has ("shortest_period_ms"))
        design.shortestPeriod = fromMilliseconds (number ("shortest_period_ms"));

    design.choices = readSentences (object.required ("choices"));
    design.warnings = readSentences (object.required ("warnings"));
    return design;
}
} // namespace antinode
