#include "Field.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
constexpr double boundless = 1e12;

std::string keywordOf (std::string option)
{
    option.erase (0, option.find_first_not_of ('-'));
    std::replace (option.begin(), option.end(), '-', '_');
    return option;
}
} // namespace

Field::Field (std::string optionName, FieldValue member, std::string sentence)
    : option (std::move (optionName)), keyword (keywordOf (option)), value (std::move (member)),
      text (std::move (sentence))
{
}

Field& Field::as (std::string name)
{
    keyword = std::move (name);
    return *this;
}

Field& Field::in (double unitsPerSi)
{
    perUnit = unitsPerSi;
    return *this;
}

Field& Field::within (double least, double most)
{
    range = { least, most };
    return *this;
}

Field& Field::positive()
{
    return within (1e-12, boundless);
}

Field& Field::oneOf (std::vector<std::string> allowed)
{
    words = std::move (allowed);
    return *this;
}

Field& Field::by (std::string reason)
{
    otherwise = std::move (reason);
    return *this;
}

Field& Field::written (std::string text, char separatedBy)
{
    form = std::move (text);
    separator = separatedBy;
    return *this;
}

Field& Field::usually (std::string document)
{
    usual = std::move (document);
    return *this;
}

Field& Field::required()
{
    isRequired = true;
    return *this;
}

Field& Field::positional()
{
    isPositional = true;
    return *this;
}

Field& Field::with (std::string optionName)
{
    needs.push_back (std::move (optionName));
    return *this;
}

Field& Field::without (std::string optionName)
{
    excludes.push_back (std::move (optionName));
    return *this;
}

std::string fieldNumber (double number)
{
    return formatted ("%.12g", number);
}

std::string refusalOf (const Field& field, double given)
{
    if (! field.range || (given >= field.range->first && given <= field.range->second))
        return {};

    return "is " + fieldNumber (given) + "; allowed: " + rangeInWords (*field.range);
}

std::string refusalOf (const Field& field, const std::string& given)
{
    const std::vector<std::string_view> allowed (field.words.begin(), field.words.end());

    if (allowed.empty() || std::find (allowed.begin(), allowed.end(), given) != allowed.end())
        return {};

    return "is " + inQuotes (given) + didYouMean (given, allowed) + "; allowed: " + listed (allowed);
}

std::string rangeInWords (const std::pair<double, double>& range)
{
    if (range.second >= boundless)
        return range.first > 0 ? "above 0" : "from " + fieldNumber (range.first);

    return fieldNumber (range.first) + " to " + fieldNumber (range.second);
}

Field cacheField (bool& usesCache)
{
    return Field ("--no-cache", &usesCache, "Solves the device without reading or writing the cache").as ("cache");
}

Field quietField (bool& isQuiet)
{
    return Field ("--quiet", &isQuiet, "Prints only errors").as ({});
}

void append (std::vector<Field>& fields, std::vector<Field> more)
{
    fields.insert (fields.end(), std::make_move_iterator (more.begin()), std::make_move_iterator (more.end()));
}

namespace
{
/** The fields that errors name, and what the user writes for them. A field that begins like another one stands before
    it. */
constexpr auto namedFields = std::to_array<std::pair<std::string_view, std::string_view>> ({
    { "focus: targets", "focus: /targets" },
    { "focus: focus time", "focus: /focus_time_ms" },
    { "focus: controlled modes", "focus: /modes" },
    { "focus: number of modes", "focus: /modes/count" },
    { "focus: captured fraction", "focus: /modes/captured" },
    { "focus: maximum frequency", "focus: /modes/maximum_frequency_Hz" },
    { "focus: growth", "focus: /transients/growth" },
    { "focus: cycles", "focus: /transients/cycles" },
    { "focus: brake duration", "focus: /transients/brake_duration_ms" },
    { "focus: allocation method", "focus: /allocation/method" },
    { "focus: voltage limit", "focus: /allocation/voltage_limit_V" },
    { "focus: robustness", "focus: /allocation/robust" },
    { "device: voltage limit", "device: /limits/voltage_V" },
    { "device: full scale", "device: /limits/full_scale_V" },
    { "device: current limit", "device: /limits/current_mA" },
    { "device: slew limit", "device: /limits/slew_V_per_us" },
    { "placement: keep-out zones", "--keep-out-mm" },
    { "placement: edge distance", "--rim-mm" },
    { "placement: step", "--step-mm" },
    { "placement: ceramic size", "--size-mm" },
    { "placement: number of ceramics", "--count" },
    { "placement: number of modes", "--modes" },
    { "measurement: reference names", "--drivers" },
    { "measurement: point positions", "--points" },
    { "model orders", "--orders" },
});

void replace (std::string& text, std::string_view field, std::string_view word)
{
    for (auto at = text.find (field); at != std::string::npos; at = text.find (field, at + word.size()))
        text.replace (at, field.size(), word);
}

/** "focus: target 1 x" becomes "focus: /targets/0/x_mm": errors count from 1, JSON pointers from 0. */
void replaceTarget (std::string& text)
{
    constexpr std::string_view begin = "focus: target ";

    if (! text.starts_with (begin))
        return;

    auto end = begin.size();

    while (end < text.size() && end < begin.size() + 6 && std::isdigit (static_cast<unsigned char> (text[end])) != 0)
        ++end;

    if (end == begin.size() || end + 1 >= text.size() || text[end] != ' '
        || (text[end + 1] != 'x' && text[end + 1] != 'y'))
        return;

    const auto index = std::stoi (text.substr (begin.size(), end - begin.size())) - 1;
    text.replace (0, end + 2, "focus: /targets/" + std::to_string (index) + '/' + text[end + 1] + "_mm");
}
} // namespace

std::string withKeysAndOptions (std::string message)
{
    replaceTarget (message);

    for (const auto& [field, word] : namedFields)
        replace (message, field, word);

    return message;
}
} // namespace antinode
