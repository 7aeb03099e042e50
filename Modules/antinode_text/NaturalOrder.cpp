#include "NaturalOrder.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace antinode
{
namespace
{
/** Where the number at the end of a name begins, its sign included where nothing stands before it. */
std::size_t numberBegin (const std::string& name)
{
    const auto last = name.find_last_not_of ("0123456789");
    return last == std::string::npos || (last == 0 && name[0] == '-') ? 0 : last + 1;
}

std::int64_t trailingNumber (const std::string& name)
{
    std::int64_t number = 0;
    std::from_chars (name.data() + numberBegin (name), name.data() + name.size(), number);
    return number;
}
} // namespace

std::vector<std::string> inNaturalOrder (std::vector<std::string> names)
{
    const auto prefix = [] (const std::string& name) { return name.substr (0, numberBegin (name)); };
    const auto isAlike = [&] (const auto& name)
    { return prefix (name) == prefix (names.front()) && numberBegin (name) < name.size(); };

    if (std::all_of (names.begin(), names.end(), isAlike))
        std::stable_sort (names.begin(), names.end(),
                          [] (const auto& a, const auto& b) { return trailingNumber (a) < trailingNumber (b); });

    return names;
}
} // namespace antinode
