#include "DesignFile.h"
#include "FileUnits.h"
#include "FocusFile.h"
#include "FocusWords.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/FocusMoments.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_focus/Projection.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/PhysicalRanges.h>

#include <cmath>
#include <utility>

namespace antinode
{
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
