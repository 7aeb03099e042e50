#include "TrackingState.h"

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr int mostCeramics = 64;
constexpr double farthest = 1e12; // mm: the tracker says what is outside the surface
} // namespace

std::string trackingToText (const TrackingSettings& tracking)
{
    nlohmann::ordered_json json { { "sensor", wordFor (trackingSensorWords, tracking.sensor) } };

    if (tracking.isCeramic())
        json["ceramic"] = tracking.ceramic + 1;
    else
    {
        json["x_mm"] = tracking.xMillimetres;
        json["y_mm"] = tracking.yMillimetres;
    }

    if (tracking.isFrozen)
        json["frozen"] = true;

    return json.dump();
}

TrackingSettings trackingFromJson (const JsonValue& value)
{
    const auto json = value.object ({ "sensor", "ceramic", "x_mm", "y_mm", "frozen" });
    TrackingSettings tracking;
    tracking.sensor = json.required ("sensor").choice (trackingSensorWords);

    if (tracking.isCeramic())
        tracking.ceramic = json.required ("ceramic").integer (1, mostCeramics) - 1;
    else
    {
        tracking.xMillimetres = json.required ("x_mm").number ({ -farthest, farthest });
        tracking.yMillimetres = json.required ("y_mm").number ({ -farthest, farthest });
    }

    if (const auto frozen = json.optional ("frozen"))
        tracking.isFrozen = frozen->boolean();

    return tracking;
}
} // namespace antinode
