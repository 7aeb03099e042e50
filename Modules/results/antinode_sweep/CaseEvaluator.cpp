#include "CaseEvaluator.h"

#include "CaseStudies.h"
#include "SweepCases.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/JsonText.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace antinode
{
CaseKeys keysOf (const CaseKeys& all, std::string_view prefix)
{
    CaseKeys some;

    for (const auto& [key, value] : all)
        if (key.starts_with (prefix))
            some.emplace_back (key.substr (prefix.size()), value);

    return some;
}

std::string textOf (const CaseKeys& keys)
{
    std::string text;

    for (const auto& [key, value] : keys)
        text += key + "=" + value.dump() + "\n";

    return text;
}

nlohmann::json assigned (nlohmann::json document, const CaseKeys& keys)
{
    for (const auto& [key, value] : keys)
        applyAssignment (document, key + "=" + value.dump());

    return document;
}

nlohmann::json deviceDocument (const SweepInputs& inputs, const CaseKeys& keys)
{
    const auto varied =
        std::find_if (keys.begin(), keys.end(), [] (const auto& each) { return each.first == "device"; });
    return assigned (inputs.device (varied == keys.end() ? std::string() : varied->second.get<std::string>()),
                     keysOf (keys, "device."));
}

std::string deviceText (const CaseKeys& keys)
{
    return textOf (keysOf (keys, "device"));
}

namespace
{
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

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

std::unique_ptr<const CaseStudy> studyOf (const SweepInputs& inputs, bool usesCache)
{
    if (inputs.plan.isOfWaveforms())
        return std::make_unique<WaveformsStudy> (inputs, usesCache);

    return std::make_unique<FocusStudy> (inputs, usesCache);
}
} // namespace

CaseEvaluator::CaseEvaluator (SweepInputs inputsToUse, bool usesCache)
    : given (std::make_unique<const SweepInputs> (std::move (inputsToUse))), study (studyOf (*given, usesCache))
{
}

nlohmann::ordered_json CaseEvaluator::summaryOf (std::uint64_t number) const
{
    const auto keys = caseAssignments (given->plan, number);
    return study->summary (keys, readDeviation (keys), deviationSeed (given->plan, number));
}

void CaseEvaluator::check() const
{
    constexpr std::uint64_t tries = 16;
    const auto& plan = given->plan;
    const auto first = caseAssignments (plan, 0);
    study->check (first);
    readDeviation (first);
    std::string refused;

    for (std::uint64_t i = 0; i < tries; ++i)
    {
        try
        {
            const auto summary = summaryOf (i * plan.cases / tries);

            for (const auto& key : plan.record)
                if (const auto* const value = findValue (summary, key); value == nullptr || ! isNumber (*value))
                    throw InputError (
                        "record", inQuotes (key) + " is not the number of a case; allowed: " + allowedKeys (summary));

            return;
        }
        catch (const InputError& error)
        {
            if (std::string (error.what()).starts_with ("record: "))
                throw;

            refused = refused.empty() ? error.what() : refused;
        }
    }

    throw InputError ("sweep", "none of 16 cases that were tried can be computed; the first error: " + refused);
}

CaseResult CaseEvaluator::evaluate (std::uint64_t number) const
{
    const auto& plan = given->plan;
    CaseResult result;

    try
    {
        const auto summary = summaryOf (number);

        for (const auto& key : plan.record)
            result.values.push_back (numberOf (findValue (summary, key)));

        if (const auto* const fields = findValue (summary, pointKey))
            for (const auto& value : *fields)
                result.values.push_back (numberOf (&value));
    }
    catch (const InputError& error)
    {
        result = { std::vector<double> (plan.record.size() + plan.points.size(), missing), error.what() };
    }

    return result;
}
} // namespace antinode
