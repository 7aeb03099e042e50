#include "Field.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <iterator>

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

std::string rangeInWords (const std::pair<double, double>& range)
{
    const auto shown = [] (double number) { return formatted ("%.10g", number); };

    if (range.second >= boundless)
        return range.first > 0 ? "above 0" : "from " + shown (range.first);

    return shown (range.first) + " to " + shown (range.second);
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
