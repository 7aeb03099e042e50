#include "NaturalOrder.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <utility>

namespace antinode
{
namespace
{
/** Numbers of any length by their size; those with a sign below 0. */
bool isLess (const std::string& one, const std::string& other)
{
    const auto isBelow = [] (const std::string& number) { return number.starts_with ('-'); };
    const auto digits = [] (const std::string& number)
    { return number.substr (std::min (number.find_first_not_of ("-0"), number.size())); };

    if (isBelow (one) != isBelow (other))
        return isBelow (one);

    auto smaller = digits (one), larger = digits (other);

    if (isBelow (one))
        std::swap (smaller, larger);

    return smaller.size() != larger.size() ? smaller.size() < larger.size() : smaller < larger;
}
} // namespace

NumberedName numberedName (const std::string& name)
{
    NumberedName numbered;
    const auto isDigit = [] (char character) { return std::isdigit (static_cast<unsigned char> (character)) != 0; };

    for (std::size_t at = 0; at < name.size(); ++at)
    {
        const auto isSign = at == 0 && name[0] == '-' && name.size() > 1 && isDigit (name[1]);

        if (! isSign && ! isDigit (name[at]))
        {
            numbered.form += name[at];
            continue;
        }

        const auto begin = at;

        while (at + 1 < name.size() && isDigit (name[at + 1]))
            ++at;

        numbered.form += '#';
        numbered.numbers.push_back (name.substr (begin, at + 1 - begin));
    }

    return numbered;
}

std::vector<std::string> inNaturalOrder (std::vector<std::string> names)
{
    std::vector<std::pair<NumberedName, std::string>> numbered;
    numbered.reserve (names.size());

    for (const auto& name : names)
        numbered.emplace_back (numberedName (name), name);

    if (std::any_of (numbered.begin(), numbered.end(),
                     [&] (const auto& each) { return each.first.form != numbered.front().first.form; }))
        return names;

    std::stable_sort (numbered.begin(), numbered.end(),
                      [] (const auto& a, const auto& b)
                      {
                          return std::lexicographical_compare (a.first.numbers.begin(), a.first.numbers.end(),
                                                               b.first.numbers.begin(), b.first.numbers.end(), isLess);
                      });
    std::transform (numbered.begin(), numbered.end(), names.begin(), [] (const auto& each) { return each.second; });
    return names;
}

std::string orderRemark (const std::vector<std::string>& given, const std::vector<std::string>& read)
{
    const auto fileName = [] (const std::string& path) { return path.substr (path.find_last_of ("/\\") + 1); };
    return given == read ? ""
                         : "Files are read in the order of the numbers in their names: " + fileName (read.front())
                               + ", " + fileName (read[1]) + " to " + fileName (read.back()) + ".";
}
} // namespace antinode
