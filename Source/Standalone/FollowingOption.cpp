#include "FollowingOption.h"

#include "ColonNumbers.h"
#include "OutputRouting.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace antinode
{
namespace
{
[[noreturn]] void refuseFollowing (const std::string& text, const std::string& wrong)
{
    throw InputError ("--follow " + text, wrong
                                              + "; allowed: velocity:X:Y or displacement:X:Y, in mm, ceramic_current:N "
                                                "or ceramic_charge:N, from 1 to "
                                              + std::to_string (OutputRouting::maximumCeramics) + ", or none");
}
} // namespace

FollowingSettings readFollowing (const std::string& text)
{
    FollowingSettings settings;

    if (text == "none")
        return settings;

    const auto colon = static_cast<std::size_t> (std::find (text.begin(), text.end(), ':') - text.begin());
    const auto* const sensor = std::find_if (followingSensorWords.begin(), followingSensorWords.end(),
                                             [word = std::string_view (text).substr (0, colon)] (const auto& entry)
                                             { return entry.first == word; });

    if (sensor == followingSensorWords.end())
        refuseFollowing (text, "is no sensor");

    settings.sensor = sensor->second;
    const std::optional<std::vector<double>> behind =
        colon < text.size() ? colonNumbers (std::string_view (text).substr (colon + 1)) : std::vector<double>();

    if (! behind)
        refuseFollowing (text, "has something that is no number");

    const auto& numbers = *behind;

    if (numbers.size() != (settings.isCeramic() ? 1 : 2))
        refuseFollowing (text, settings.isCeramic() ? "does not say one ceramic" : "does not say one place");

    if (! settings.isCeramic())
    {
        settings.xMillimetres = numbers[0];
        settings.yMillimetres = numbers[1];
        return settings;
    }

    if (! (numbers[0] >= 1 && numbers[0] <= OutputRouting::maximumCeramics) || numbers[0] != std::floor (numbers[0]))
        refuseFollowing (text, "is no number of a ceramic");

    settings.ceramic = static_cast<int> (numbers[0]) - 1;
    return settings;
}
} // namespace antinode
