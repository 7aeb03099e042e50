#include "SweptKeysReader.h"

#include "Deviation.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <cmath>
#include <limits>

namespace antinode
{
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
        value.fail ("is " + inQuotes (key) + "; allowed: the plan's own key 'device', one for all cases");

    if (! (key.starts_with ("device.") || key.starts_with ("focus.") || key.starts_with ("waveforms."))
        || key.ends_with ('.') || key.find ("..") != std::string::npos || key.find ('=') != std::string::npos)
        value.fail (inQuotes (key)
                    + " is not a key; allowed: device.KEY, focus.KEY, waveforms.KEY or deviation.KEY, for example "
                      "focus.targets.0.x_mm");

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
