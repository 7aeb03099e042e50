#include "CaseEvaluator.h"

#include "SweepCases.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_fingers/OneSidedContact.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/Prediction.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_render/Summary.h>
#include <antinode_text/JsonText.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr std::size_t devicesToKeep = 2, designsToKeep = 8;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr auto pointKey = "field_at_points_mm_s";

/** The keys of one document, without its name. */
std::vector<std::pair<std::string, nlohmann::json>>
assignmentsOf (const std::vector<std::pair<std::string, nlohmann::json>>& all, std::string_view prefix)
{
    std::vector<std::pair<std::string, nlohmann::json>> some;

    for (const auto& [key, value] : all)
        if (key.starts_with (prefix))
            some.emplace_back (key.substr (prefix.size()), value);

    return some;
}

std::string textOf (const std::vector<std::pair<std::string, nlohmann::json>>& assignments)
{
    std::string text;

    for (const auto& [key, value] : assignments)
        text += key + "=" + value.dump() + "\n";

    return text;
}

nlohmann::json assigned (nlohmann::json document, const std::vector<std::pair<std::string, nlohmann::json>>& keys)
{
    for (const auto& [key, value] : keys)
        applyAssignment (document, key + "=" + value.dump());

    return document;
}

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

/** The value of a key with points between its parts; none where there is no such key. */
const nlohmann::ordered_json* findValue (const nlohmann::ordered_json& summary, const std::string& key)
{
    const auto* at = &summary;

    for (std::size_t begin = 0; begin <= key.size();)
    {
        const auto end = std::min (key.find ('.', begin), key.size());
        const auto part = key.substr (begin, end - begin);
        const auto isIndex =
            ! part.empty() && part.size() < 6 && part.find_first_not_of ("0123456789") == std::string::npos;

        if (at->is_object() && at->contains (part))
            at = &at->at (part);
        else if (at->is_array() && isIndex && std::stoul (part) < at->size())
            at = &at->at (std::stoul (part));
        else
            return nullptr;

        begin = end + 1;
    }

    return at;
}

bool isNumber (const nlohmann::ordered_json& json)
{
    return json.is_number() || json.is_boolean() || json.is_null();
}

double numberOf (const nlohmann::ordered_json* json)
{
    if (json == nullptr || ! (json->is_number() || json->is_boolean()))
        return missing;

    const auto number = json->is_boolean() ? static_cast<double> (json->get<bool>()) : json->get<double>();
    return std::isfinite (number) ? number : missing;
}

/** All keys of a summary that hold numbers. */
void listNumbers (const nlohmann::ordered_json& json, const std::string& prefix, std::vector<std::string>& keys)
{
    for (const auto& [key, value] : json.items())
        if (value.is_structured())
            listNumbers (value, prefix + key + ".", keys);
        else if (isNumber (value) && prefix + key != "solver.time_ms")
            keys.push_back (prefix + key);
}

std::string allowedKeys (const nlohmann::ordered_json& summary)
{
    std::vector<std::string> keys;
    listNumbers (summary, {}, keys);
    return listed ({ keys.begin(), keys.end() });
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

struct CaseEvaluator::SolvedDevice
{
    DeviceDescription description;
    WideModel wide;
};

struct CaseEvaluator::MadeDesign
{
    WideDesign made;
    ModalModel modes; ///< Of the played model, without shapes.
    FieldPeak wantedPeak, truncatedPeak;
};

std::vector<std::string> sweepColumns (const SweepPlan& plan)
{
    auto columns = plan.record;

    for (const auto& [x, y] : plan.points)
        columns.push_back ("field_mm_s_at_" + numberText (x * milli) + "_" + numberText (y * milli));

    return columns;
}

CaseEvaluator::CaseEvaluator (SweepInputs inputsToUse, bool usesCacheToUse)
    : given (std::move (inputsToUse)), playback { Reconstruction::bandLimited, given.plan.sampleRate },
      extent (neededExtent (given.plan)), usesCache (usesCacheToUse), devices (devicesToKeep), designs (designsToKeep)
{
}

std::shared_ptr<const CaseEvaluator::SolvedDevice> CaseEvaluator::deviceOf (const Assignments& all) const
{
    const auto keys = assignmentsOf (all, "device.");
    const auto solve = [&]
    {
        auto description = readDevice (assigned (given.device(), keys), "device");
        const auto known = solveDevice (description, {}, usesCache);
        auto wide = solveWide (description, known, frequencyBeyond (known, playback.sampleRate), usesCache);
        return SolvedDevice { std::move (description), std::move (wide) };
    };
    return devices.get (textOf (keys), solve);
}

std::shared_ptr<const CaseEvaluator::MadeDesign> CaseEvaluator::designOf (const Assignments& all) const
{
    const auto keys = assignmentsOf (all, "focus.");
    const auto make = [&]
    {
        const auto focus = focusFromDocument (assigned (given.focus(), keys), "focus", "focus");
        const auto device = deviceOf (all);
        const auto widen = [&] (const ModalModel& known, double frequency)
        { return solveWide (device->description, known, frequency, usesCache); };
        MadeDesign design { designWide (device->wide, focus, playback, widen, extent), {}, {}, {} };
        const auto& model = design.made.wide.model;
        const auto& moment = design.made.design.moments.front();
        design.modes = withoutShapes (model);
        design.truncatedPeak = largestTruncated (model, design.made.design, moment);
        design.wantedPeak = largestWanted (model.surface, moment.targets, focus.edgeWindow);
        return design;
    };
    return designs.get (textOf (assignmentsOf (all, "device.")) + "\n" + textOf (keys), make);
}

nlohmann::ordered_json CaseEvaluator::closedForm (const MadeDesign& designed, const Deviation& deviation,
                                                  std::uint64_t seed) const
{
    const auto& [wide, design] = designed.made;
    const auto& moment = design.moments.front();

    if (canLiftOff (design.description.fingers))
        throw InputError ("evaluate", "is closed_form, which knows no fingers that lift off; allowed: render");

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

nlohmann::ordered_json CaseEvaluator::rendered (const MadeDesign& designed, const Deviation& deviation,
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

nlohmann::ordered_json CaseEvaluator::summaryOf (std::uint64_t number) const
{
    const auto assignments = caseAssignments (given.plan, number);
    const auto deviation = readDeviation (assignments);
    const auto seed = deviationSeed (given.plan, number);
    const auto designed = designOf (assignments);

    if (! deviation.isNone())
        requireRealModes (designed->made.wide.model, "deviations");

    return given.plan.evaluation == SweepEvaluation::closedForm ? closedForm (*designed, deviation, seed)
                                                                : rendered (*designed, deviation, seed);
}

void CaseEvaluator::check() const
{
    constexpr std::uint64_t tries = 16;
    const auto& plan = given.plan;
    const auto first = caseAssignments (plan, 0);
    readDevice (assigned (given.device(), assignmentsOf (first, "device.")), "case 0: device");
    focusFromDocument (assigned (given.focus(), assignmentsOf (first, "focus.")), "case 0: focus", "focus");
    readDeviation (first);
    std::string refused;

    for (std::uint64_t i = 0; i < tries; ++i)
    {
        try
        {
            const auto summary = summaryOf (i * plan.cases / tries);

            for (const auto& key : plan.record)
                if (const auto* const value = findValue (summary, key); value == nullptr || ! isNumber (*value))
                    throw InputError ("record",
                                      inQuotes (key) + " is no number of a case; allowed: " + allowedKeys (summary));

            return;
        }
        catch (const InputError& error)
        {
            if (std::string (error.what()).starts_with ("record: "))
                throw;

            refused = refused.empty() ? error.what() : refused;
        }
    }

    throw InputError ("sweep", "none of 16 cases that were tried can be computed; the first says: " + refused);
}

CaseResult CaseEvaluator::evaluate (std::uint64_t number) const
{
    const auto& plan = given.plan;
    CaseResult result;

    try
    {
        const auto summary = summaryOf (number);

        for (const auto& key : plan.record)
            result.values.push_back (numberOf (findValue (summary, key)));

        for (const auto& value : summary[pointKey])
            result.values.push_back (numberOf (&value));
    }
    catch (const InputError& error)
    {
        result = { std::vector<double> (plan.record.size() + plan.points.size(), missing), error.what() };
    }

    return result;
}
} // namespace antinode
