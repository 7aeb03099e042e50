#include "JsonReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t longestPlace = 300; ///< Of a source or a pointer in a message, in bytes.

std::string countText (std::size_t minimum, std::size_t maximum)
{
    return minimum == maximum ? std::to_string (minimum) : std::to_string (minimum) + " to " + std::to_string (maximum);
}

/** JSON pointers write ~ as ~0 and / as ~1 (RFC 6901). */
std::string escaped (std::string_view key)
{
    std::string result;

    for (const auto character : key)
        if (character == '~' || character == '/')
            result += character == '~' ? "~0" : "~1";
        else
            result += character;

    return result;
}
} // namespace

bool NumberRange::contains (double value) const
{
    return value >= minimum && value <= maximum && ! (aboveMinimum && value == minimum)
           && ! (belowMaximum && value == maximum);
}

std::string NumberRange::text() const
{
    return (aboveMinimum ? "above " : "") + numberText (minimum) + (belowMaximum ? " to below " : " to ")
           + numberText (maximum);
}

JsonValue::JsonValue (const nlohmann::json& document, const std::string& sourceName)
    : JsonValue (document, printable (sourceName, longestPlace), {})
{
}

JsonValue::JsonValue (const nlohmann::json& value, std::string sourceName, std::string place)
    : json (&value), source (std::move (sourceName)), pointer (std::move (place))
{
}

JsonValue JsonValue::child (std::string_view key, const nlohmann::json& value) const
{
    return { value, source, pointer + '/' + printable (escaped (key)) };
}

double JsonValue::number (const NumberRange& range) const
{
    const auto value = json->is_number() ? json->get<double>() : std::nan ("");

    if (! range.contains (value))
        fail (description() + "; allowed: " + (json->is_number() ? "" : "a number, ") + range.text());

    return value;
}

int JsonValue::integer (int minimum, int maximum) const
{
    const auto value = json->is_number() ? json->get<double>() : std::nan ("");

    if (! (value >= minimum && value <= maximum && value == std::floor (value)))
        fail (description() + "; allowed: a whole number from " + std::to_string (minimum) + " to "
              + std::to_string (maximum));

    return static_cast<int> (value);
}

bool JsonValue::boolean() const
{
    if (! json->is_boolean())
        fail (description() + "; allowed: true or false");

    return json->get<bool>();
}

int JsonValue::sign() const
{
    if (*json != 1 && *json != -1)
        fail (description() + "; allowed: 1 or -1");

    return *json == 1 ? 1 : -1;
}

std::string JsonValue::text (std::size_t maximumBytes, bool lineBreaksAllowed) const
{
    if (! json->is_string())
        fail (description() + "; allowed: text");

    const auto& text = json->get_ref<const std::string&>();

    if (text.size() > maximumBytes)
        fail ("is too long; allowed: up to " + std::to_string (maximumBytes) + " bytes");

    auto line = text;

    if (lineBreaksAllowed)
        std::erase (line, '\n');

    if (printable (line, line.size()) != line)
        fail ("has control characters; allowed: plain text in UTF-8");

    return text;
}

void JsonValue::requireCount (std::size_t minimum, std::size_t maximum) const
{
    const auto allowed = "; allowed: a list of " + countText (minimum, maximum);

    if (! json->is_array())
        fail (description() + allowed);

    if (json->size() < minimum || json->size() > maximum)
        fail ("has " + std::to_string (json->size()) + " entries" + allowed);
}

std::vector<JsonValue> JsonValue::items (std::size_t minimum, std::size_t maximum) const
{
    requireCount (minimum, maximum);
    std::vector<JsonValue> result;
    result.reserve (json->size());

    for (const auto& entry : *json)
        result.push_back (child (std::to_string (result.size()), entry));

    return result;
}

std::vector<double> JsonValue::numbers (std::size_t minimumCount, std::size_t maximumCount,
                                        const NumberRange& range) const
{
    requireCount (minimumCount, maximumCount);
    std::vector<double> result;
    result.reserve (json->size());

    // Shapes are long lists: the pointer of an entry is composed only for an error.
    for (const auto& entry : *json)
    {
        const auto allowed = entry.is_number() && range.contains (entry.get<double>());
        result.push_back (allowed ? entry.get<double>() : child (std::to_string (result.size()), entry).number (range));
    }

    return result;
}

std::vector<double> JsonValue::numberOrNumbers (std::size_t maximumCount, const NumberRange& range) const
{
    if (json->is_array())
        return numbers (1, maximumCount, range);

    if (! json->is_number())
        fail (description() + "; allowed: a number, " + range.text() + ", or a list of them");

    return { number (range) };
}

JsonObject JsonValue::object (std::vector<std::string_view> allowedKeys) const
{
    return { *this, std::move (allowedKeys) };
}

std::optional<JsonValue> JsonValue::find (std::string_view key) const
{
    if (! json->is_object())
        fail (description() + "; allowed: an object");

    const auto found = json->find (key);

    if (found == json->end())
        return std::nullopt;

    return child (key, *found);
}

JsonValue JsonValue::required (std::string_view key) const
{
    if (auto found = find (key))
        return *found;

    child (key, {}).fail ("is missing");
}

void JsonValue::requireSchema (std::string_view schema) const
{
    if (const auto given = required ("schema"); ! given.isWord (schema))
        given.fail (given.description() + "; allowed: " + inQuotes (schema));
}

void JsonValue::fail (const std::string& wrong) const
{
    throw InputError (pointer.empty() ? source : source + ": " + printable (pointer, longestPlace), wrong);
}

void JsonValue::failChoice (const std::vector<std::string_view>& allowed) const
{
    const auto hint = json->is_string() ? didYouMean (json->get_ref<const std::string&>(), allowed) : std::string {};
    fail (description() + hint + "; allowed: " + (allowed.size() > 1 ? "one of " : "") + listed (allowed));
}

std::string JsonValue::description() const
{
    if (json->is_string())
        return "is the text " + inQuotes (json->get_ref<const std::string&>());

    if (json->is_number())
        return "is " + numberText (json->get<double>());

    if (json->is_boolean())
        return json->get<bool>() ? "is true" : "is false";

    return json->is_array() ? "is a list" : json->is_object() ? "is an object" : "is null";
}

JsonObject::JsonObject (JsonValue valueToRead, std::vector<std::string_view> allowedKeys)
    : value (std::move (valueToRead))
{
    if (! value.isObject())
        value.fail (value.description() + "; allowed: an object with the keys " + listed (allowedKeys));

    for (const auto& [key, entry] : value.json->items())
        if (std::find (allowedKeys.begin(), allowedKeys.end(), key) == allowedKeys.end())
            value.child (key, entry)
                .fail ("is an unknown key" + didYouMean (key, allowedKeys) + "; allowed: " + listed (allowedKeys));
}

std::pair<std::string_view, JsonValue> JsonObject::oneOf (std::string_view first, std::string_view second) const
{
    if (has (first) == has (second))
        value.fail ((has (first) ? "has both " : "has neither ") + inQuotes (first) + (has (first) ? " and " : " nor ")
                    + inQuotes (second) + "; allowed: exactly one of the two");

    const auto given = has (first) ? first : second;
    return { given, required (given) };
}
} // namespace antinode
