#include "FollowingState.h"

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr int mostCeramics = 64;
constexpr double farthest = 1e12; // mm: the follower says what is outside the surface
} // namespace

std::string followingToText (const FollowingSettings& following)
{
    nlohmann::ordered_json json { { "sensor", wordFor (followingSensorWords, following.sensor) } };

    if (following.isCeramic())
        json["ceramic"] = following.ceramic + 1;
    else
    {
        json["x_mm"] = following.xMillimetres;
        json["y_mm"] = following.yMillimetres;
    }

    if (following.isFrozen)
        json["frozen"] = true;

    return json.dump();
}

FollowingSettings followingFromJson (const JsonValue& value)
{
    const auto json = value.object ({ "sensor", "ceramic", "x_mm", "y_mm", "frozen" });
    FollowingSettings following;
    following.sensor = json.required ("sensor").choice (followingSensorWords);

    if (following.isCeramic())
        following.ceramic = json.required ("ceramic").integer (1, mostCeramics) - 1;
    else
    {
        following.xMillimetres = json.required ("x_mm").number ({ -farthest, farthest });
        following.yMillimetres = json.required ("y_mm").number ({ -farthest, farthest });
    }

    if (const auto frozen = json.optional ("frozen"))
        following.isFrozen = frozen->boolean();

    return following;
}
} // namespace antinode
