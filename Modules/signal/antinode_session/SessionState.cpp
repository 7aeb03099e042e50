#include "SessionState.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr int maximumMutes = 64;
constexpr double farthest = 1e12; // of a parameter, and mm: what takes it cuts it to its own range

std::vector<std::string_view> keysOf (const SessionRole& role)
{
    std::vector<std::string_view> keys { "schema", "device", "parameters" };

    if (role.keepsFocus)
        keys.insert (keys.end(), { "focus", "design", "tracking" });

    if (role.isOfFoci)
        keys.insert (keys.end(), { "muted_ceramics", "open_graph" });

    return keys;
}

std::map<std::string, double> readParameters (const JsonValue& value, const nlohmann::json& json)
{
    std::map<std::string, double> parameters;

    if (! value.isObject())
        value.fail ("must be an object of numbers");

    for (const auto& [key, ignored] : json.items())
        parameters[key] = value.required (key).number ({ -farthest, farthest });

    return parameters;
}

std::uint64_t readMutes (const JsonValue& value)
{
    std::uint64_t mutes = 0;

    for (const auto& item : value.items (0, maximumMutes))
        mutes |= std::uint64_t (1) << (item.integer (1, maximumMutes) - 1);

    return mutes;
}

std::string mutesToText (std::uint64_t mutes)
{
    auto muted = nlohmann::ordered_json::array();

    for (int i = 0; i < maximumMutes; ++i)
        if (((mutes >> i) & 1U) != 0)
            muted.push_back (i + 1);

    return muted.dump();
}

std::shared_ptr<const FocusDocument> readFocus (const JsonObject& state, const nlohmann::json& json)
{
    state.required ("focus");
    auto read = readFocusDocument (json["focus"], "state: focus");

    if (state.has ("design"))
        read.design = readDesignDocument (json["design"], "state: design");

    return std::make_shared<const FocusDocument> (std::move (read));
}
} // namespace

/** Documents go in as they are: a written design has megabytes, and hosts ask often. */
std::string stateToText (const SessionState& state, const SessionRole& role)
{
    auto text = R"({"schema":")" + std::string (role.schema) + R"(","device":)" + state.device->text;

    // What is as ever is left out: such a state loads in versions that do not know of it.
    if (state.focus != nullptr)
        text += R"(,"focus":)" + state.focus->text;

    if (state.focus != nullptr && state.focus->design != nullptr)
        text += R"(,"design":)" + state.focus->design->text;

    text += R"(,"parameters":)" + nlohmann::ordered_json (state.parameters).dump();

    if (role.isOfFoci)
        text += R"(,"muted_ceramics":)" + mutesToText (state.mutes);

    if (state.isGraphOpen)
        text += R"(,"open_graph":true)";

    if (state.following.isOn())
        text += R"(,"tracking":)" + followingToText (state.following);

    return text + "}";
}

SessionState readState (std::string_view text, const SessionRole& role)
{
    const auto json = parseJson (text, "state");
    const JsonValue value (json, "state");
    value.requireSchema (role.schema);
    const auto state = value.object (keysOf (role));
    const auto device = state.required ("device"), parameters = state.required ("parameters");
    const auto openGraph = state.optional ("open_graph"), following = state.optional ("tracking");
    const auto hasFocus = role.isOfFoci || state.has ("focus") || state.has ("design");

    if (! device.isObject())
        device.fail ("must be a device");

    return { std::make_shared<const DeviceDocument> (readDeviceDocument (json["device"], "state: device")),
             hasFocus ? readFocus (state, json) : nullptr,
             readParameters (parameters, json["parameters"]),
             role.isOfFoci ? readMutes (state.required ("muted_ceramics")) : 0,
             openGraph && openGraph->boolean(),
             following ? followingFromJson (*following) : FollowingSettings() };
}

namespace
{
constexpr int mostCeramics = 64;
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
