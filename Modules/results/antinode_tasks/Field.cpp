#include "Field.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <iterator>
#include <string_view>

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
} // namespace antinode
