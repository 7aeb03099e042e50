#include "SweepPlan.h"

#include "Deviation.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace antinode
{
namespace
{
constexpr std::string_view schema = "antinode.sweep/1";
constexpr std::size_t longestText = 200, longestFileName = 4000, mostDimensions = 64, mostPoints = 100;

constexpr WordList<SweepScheme, 2> schemeWords { { { "grid", SweepScheme::grid }, { "random", SweepScheme::random } } };
constexpr WordList<SweepEvaluation, 2> evaluationWords { { { "render", SweepEvaluation::render },
                                                           { "closed_form", SweepEvaluation::closedForm } } };

SweepScheme readScheme (const JsonValue& value)
{
    for (const auto* moved : { "latin_hypercube", "sobol", "saltelli" })
        if (value.text (longestText) == moved)
            value.fail ("is " + inQuotes (moved)
                        + "; allowed: grid, random; antinode.sampled of Python makes a plan with " + moved);

    return value.choice (schemeWords);
}

/** All combinations. */
std::uint64_t gridCases (const JsonValue& root, const SweepPlan& plan)
{
    std::uint64_t cases = 1;

    for (std::size_t i = 0; i < plan.vary.size(); ++i)
    {
        if (plan.vary[i].drawn)
            root.fail ("draws " + inQuotes (plan.vary[i].keys.front())
                       + ", which a grid cannot; allowed: listed values or a range, or another 'scheme'");

        cases *= plan.vary[i].rows.size();

        if (cases > maximumSweepCases)
            root.fail ("has more cases than " + std::to_string (maximumSweepCases) + "; allowed: fewer values");
    }

    return cases;
}

std::uint64_t readCases (const JsonObject& object, const JsonValue& root, const SweepPlan& plan)
{
    if (plan.scheme == SweepScheme::random)
        return static_cast<std::uint64_t> (object.required ("cases").integer (1, static_cast<int> (maximumSweepCases)));

    if (object.has ("cases"))
        root.fail ("'cases' does not fit the scheme; allowed: with random only");

    return gridCases (root, plan);
}

/** Keys are of the documents that the plan has. */
void checkDocuments (const JsonValue& root, const SweepPlan& plan)
{
    const auto* const absent = plan.isOfWaveforms() ? "focus." : "waveforms.";
    const auto check = [&] (const std::string& key)
    {
        if (key.starts_with (absent))
            root.fail ("gives " + inQuotes (key) + ", but has no " + (plan.isOfWaveforms() ? "focus" : "waveforms")
                       + "; allowed: keys of its own documents");
    };

    for (const auto& [key, value] : plan.set)
        check (key);

    for (const auto& swept : plan.vary)
        for (const auto& key : swept.keys)
            check (key);
}

/** A key has one value. */
void checkUnique (const JsonValue& root, const SweepPlan& plan)
{
    std::set<std::string> known;
    const auto add = [&] (const std::string& key)
    {
        if (! known.insert (key).second)
            root.fail ("gives " + inQuotes (key) + " twice; allowed: once");
    };

    for (const auto& [key, value] : plan.set)
        add (key);

    for (const auto& swept : plan.vary)
        for (const auto& key : swept.keys)
            add (key);
}

/** Devices that vary have names, and the plan gives no other one. */
void checkDevices (const JsonValue& root, const SweepPlan& plan)
{
    for (const auto& swept : plan.vary)
        for (std::size_t k = 0; k < swept.keys.size(); ++k)
            if (swept.keys[k] == "device"
                && (swept.drawn
                    || std::any_of (swept.rows.begin(), swept.rows.end(),
                                    [&] (const auto& row) { return ! row[k].is_string(); })))
                root.fail ("varies 'device' by numbers; allowed: 'values' that are names or files");

    if (! plan.variedDevices().empty() && ! plan.device.is_null())
        root.fail ("gives 'device' twice; allowed: once, of the plan or in 'vary'");
}

/** A name, a file's name, or a whole document. */
nlohmann::json readDocument (const JsonValue& value, const nlohmann::json& json)
{
    if (! value.isObject())
        value.text (longestFileName);

    return json;
}

void readRecord (const JsonObject& object, SweepPlan& plan)
{
    if (const auto value = object.optional ("record"))
        for (const auto& each : value->items (0, maximumSweepColumns))
        {
            plan.record.push_back (each.text (longestText));

            if (plan.record.back() == "solver.time_ms")
                each.fail ("is a time, which differs from run to run; allowed: other keys of summary.json");

            if (std::count (plan.record.begin(), plan.record.end(), plan.record.back()) > 1)
                each.fail (inQuotes (plan.record.back()) + " is there twice; allowed: once");
        }

    if (const auto value = object.optional ("points_mm"))
        for (const auto& each : value->items (0, mostPoints))
        {
            const auto place = each.numbers (2, 2, { -1e5, 1e5 });
            plan.points.emplace_back (place[0] / milli, place[1] / milli);
        }

    if (plan.isOfWaveforms() && ! plan.points.empty())
        object.fail ("has 'points_mm', which are of a focus; allowed with waveforms: silent fingers there, "
                     "and 'fingers.N.reached_peak_um' in 'record'");

    if (plan.record.empty() && plan.points.empty())
        object.fail ("records nothing; allowed: keys of summary.json in 'record', places in 'points_mm'");
}

/** What is played, and how. */
void readPlayed (const JsonObject& object, const nlohmann::json& document, SweepPlan& plan)
{
    constexpr double usualTrackRate = 48000, leastTrackRate = 1000, leastFocusRate = 8000, highestRate = 2e6; // Hz
    const auto [name, value] = object.oneOf ("focus", "waveforms");
    (name == "focus" ? plan.focus : plan.waveforms) = readDocument (value, document[std::string (name)]);

    if (const auto device = object.optional ("device"))
        plan.device = readDocument (*device, document["device"]);

    if (const auto devices = object.optional ("devices"))
    {
        if (! devices->isObject())
            devices->fail (devices->description() + "; allowed: an object of names and documents");

        plan.devices = document["devices"];
    }

    if (plan.isOfWaveforms())
        plan.sampleRate = usualTrackRate;

    if (const auto rate = object.optional ("rate_Hz"))
        plan.sampleRate = rate->number ({ plan.isOfWaveforms() ? leastTrackRate : leastFocusRate, highestRate });

    if (const auto evaluate = object.optional ("evaluate"))
        plan.evaluation = evaluate->choice (evaluationWords);

    if (plan.isOfWaveforms() && plan.evaluation == SweepEvaluation::closedForm)
        object.fail ("evaluates waveforms by 'closed_form'; allowed with waveforms: 'render'");

    if (const auto latency = object.optional ("latency_ms"))
    {
        if (! plan.isOfWaveforms())
            latency->fail ("is of waveforms; allowed with a focus: none");

        plan.latency = latency->number ({ 0.1, 100 }) / milli;
    }
}
} // namespace

std::vector<std::string> SweepPlan::variedDevices() const
{
    std::vector<std::string> names;

    for (const auto& swept : vary)
        for (std::size_t k = 0; k < swept.keys.size(); ++k)
            if (swept.keys[k] == "device")
                for (const auto& row : swept.rows)
                    names.push_back (row[k].get<std::string>());

    return names;
}

SweepPlan readSweepPlan (const nlohmann::json& document, const std::string& source)
{
    const JsonValue root (document, source);
    root.requireSchema (schema);
    const auto object =
        root.object ({ "schema", "name", "description", "focus", "waveforms", "device", "devices", "seed", "cases",
                       "scheme", "set", "vary", "evaluate", "record", "points_mm", "rate_Hz", "latency_ms" });
    SweepPlan plan;

    if (const auto value = object.optional ("name"))
        plan.name = value->text (longestText);

    if (const auto value = object.optional ("description"))
        value->text (10'000, true);

    readPlayed (object, document, plan);

    if (const auto value = object.optional ("scheme"))
        plan.scheme = readScheme (*value);

    if (const auto value = object.optional ("seed"))
        plan.seed = static_cast<std::uint64_t> (value->integer (0, std::numeric_limits<int>::max()));

    if (object.has ("set"))
    {
        const auto& entries = document["set"];
        const auto value = object.required ("set");

        if (! value.isObject())
            value.fail (value.description() + "; allowed: an object of keys and their values");

        for (const auto& [key, json] : entries.items())
        {
            if (key == "device")
                value.fail ("gives 'device'; allowed: 'device' of the plan or in 'vary'");

            plan.set.emplace_back (readSweptKey (value, key), readScalar (value.required (key), json));
        }
    }

    if (const auto value = object.optional ("vary"))
    {
        const auto items = value->items (0, mostDimensions);

        for (std::size_t i = 0; i < items.size(); ++i)
            plan.vary.push_back (readSweptKeys (items[i], document["vary"][i]));
    }

    checkDocuments (root, plan);
    checkDevices (root, plan);
    checkUnique (root, plan);
    plan.cases = readCases (object, root, plan);
    readRecord (object, plan);
    return plan;
}

namespace
{
constexpr std::size_t longestKey = 200, mostKeys = 64;
constexpr int mostValues = 100'000;
constexpr NumberRange anyNumber { -1e12, 1e12 };

std::vector<std::string> readKeys (const JsonObject& object)
{
    const auto [name, value] = object.oneOf ("key", "keys");

    if (name == "key")
        return { readSweptKey (value, value.text (longestKey)) };

    std::vector<std::string> keys;

    for (const auto& each : value.items (1, mostKeys))
        keys.push_back (readSweptKey (each, each.text (longestKey)));

    return keys;
}

std::vector<std::vector<nlohmann::json>> readRows (const JsonValue& value, const nlohmann::json& json, std::size_t keys)
{
    std::vector<std::vector<nlohmann::json>> rows;
    const auto items = value.items (1, mostValues);

    for (std::size_t i = 0; i < items.size(); ++i)
    {
        if (keys == 1)
        {
            rows.emplace_back (1, readScalar (items[i], json[i]));
            continue;
        }

        const auto cells = items[i].items (keys, keys);
        rows.emplace_back();

        for (std::size_t k = 0; k < keys; ++k)
            rows.back().push_back (readScalar (cells[k], json[i][k]));
    }

    return rows;
}

/** Evenly spaced values from one number to another, both of them included. */
std::vector<double> readRange (const JsonObject& object)
{
    const auto from = object.required ("from").number (anyNumber), to = object.required ("to").number (anyNumber);
    const auto count = object.required ("count").integer (1, mostValues);
    const auto spacing = object.optional ("spacing");
    const auto isLogarithmic =
        spacing && spacing->choice (WordList<bool, 2> { { { "linear", false }, { "logarithmic", true } } });

    if (isLogarithmic && ! (from > 0 && to > 0))
        object.fail ("goes through 0; allowed with logarithmic spacing: from and to above 0");

    if (count > 1 && from == to)
        object.fail ("is empty: from and to are the same; allowed: different ones, or a count of 1");

    std::vector<double> values;

    for (int i = 0; i < count; ++i)
    {
        const auto share = count > 1 ? static_cast<double> (i) / (count - 1) : 0.0;
        values.push_back (i == 0           ? from
                          : i + 1 == count ? to
                          : isLogarithmic  ? from * std::pow (to / from, share)
                                           : from + share * (to - from));
    }

    return values;
}

Distribution readUniform (const JsonValue& value)
{
    const auto object = value.object ({ "minimum", "maximum" });
    Distribution distribution;
    distribution.minimum = object.required ("minimum").number (anyNumber);
    distribution.maximum = object.required ("maximum").number (anyNumber);

    if (! (distribution.minimum < distribution.maximum))
        value.fail ("is empty; allowed: a minimum below the maximum");

    return distribution;
}

Distribution readNormal (const JsonValue& value)
{
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    const auto object = value.object ({ "mean", "standard_deviation", "minimum", "maximum" });
    const auto bound = [&] (const char* key, double otherwise)
    { return object.has (key) ? object.required (key).number (anyNumber) : otherwise; };
    Distribution distribution { DistributionKind::normal, bound ("minimum", -infinity), bound ("maximum", infinity) };
    distribution.mean = object.required ("mean").number (anyNumber);
    distribution.deviation = object.required ("standard_deviation").number ({ 0, 1e12 });

    if (! (distribution.minimum < distribution.maximum))
        value.fail ("is empty; allowed: a minimum below the maximum");

    // Farther out shares are no doubles any more.
    constexpr double farthest = 30;

    if (distribution.minimum > distribution.mean + farthest * distribution.deviation
        || distribution.maximum < distribution.mean - farthest * distribution.deviation)
        value.fail ("is cut off 30 standard deviations from its mean; allowed: bounds nearer to it");

    return distribution;
}

std::vector<double> readFactors (const JsonObject& object, const char* key, std::size_t count, double otherwise)
{
    if (! object.has (key))
        return std::vector<double> (count, otherwise);

    return object.required (key).numbers (count, count, anyNumber);
}

/** A row for each number: what every key gets of it. */
std::vector<std::vector<nlohmann::json>> coupledRows (const std::vector<double>& values, const SweptKeys& swept)
{
    std::vector<std::vector<nlohmann::json>> rows;

    for (const auto value : values)
    {
        rows.emplace_back();

        for (std::size_t k = 0; k < swept.keys.size(); ++k)
            rows.back().emplace_back (swept.plus[k] + swept.times[k] * value);
    }

    return rows;
}
} // namespace

std::string readSweptKey (const JsonValue& value, const std::string& key)
{
    if (key.starts_with ("deviation."))
    {
        if (! isDeviationKey (key))
            value.fail (inQuotes (key) + " is unknown; allowed: " + listed (deviationKeys()));

        return key;
    }

    if (key == "focus.device" || key == "waveforms.device")
        value.fail ("is " + inQuotes (key) + "; allowed: the plan's own key 'device', or 'device' in 'vary'");

    if (key == "device")
        return key;

    if (! (key.starts_with ("device.") || key.starts_with ("focus.") || key.starts_with ("waveforms."))
        || key.ends_with ('.') || key.find ("..") != std::string::npos || key.find ('=') != std::string::npos)
        value.fail (inQuotes (key)
                    + " is not a key; allowed: device, device.KEY, focus.KEY, waveforms.KEY or deviation.KEY, for "
                      "example focus.targets.0.x_mm");

    return key;
}

const nlohmann::json& readScalar (const JsonValue& value, const nlohmann::json& json)
{
    if (json.is_structured())
        value.fail (value.description() + "; allowed: a number, a text, true, false or null");

    if (json.is_string())
        value.text (longestKey);

    return json;
}

SweptKeys readSweptKeys (const JsonValue& value, const nlohmann::json& json)
{
    const auto object = value.object (
        { "key", "keys", "values", "from", "to", "count", "spacing", "uniform", "normal", "times", "plus" });
    SweptKeys swept;
    swept.keys = readKeys (object);
    swept.times = readFactors (object, "times", swept.keys.size(), 1);
    swept.plus = readFactors (object, "plus", swept.keys.size(), 0);
    const auto ways = static_cast<int> (object.has ("values")) + static_cast<int> (object.has ("from"))
                      + static_cast<int> (object.has ("uniform")) + static_cast<int> (object.has ("normal"));

    if (ways != 1)
        object.fail ("says " + std::string (ways == 0 ? "not" : "in several ways")
                     + " what its keys get; allowed: one of 'values', 'from' with 'to' and 'count', 'uniform' and "
                       "'normal'");

    if (object.has ("values") && (object.has ("times") || object.has ("plus")))
        object.fail ("gives 'times' or 'plus' for listed values; allowed: with a range, 'uniform' or 'normal'");

    if (object.has ("values"))
        swept.rows = readRows (object.required ("values"), json["values"], swept.keys.size());
    else if (object.has ("from"))
        swept.rows = coupledRows (readRange (object), swept);
    else
        swept.drawn = object.has ("uniform") ? readUniform (object.required ("uniform"))
                                             : readNormal (object.required ("normal"));

    return swept;
}
} // namespace antinode
