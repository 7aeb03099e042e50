#include "SessionState.h"

#include "FollowingState.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
constexpr auto schema = "antinode.state/1";
constexpr int maximumMutes = 64;
constexpr double farthest = 1e12; // of a parameter: each cuts it to its own range

std::map<std::string, double> readParameters (const JsonValue& value, const nlohmann::json& json)
{
    std::map<std::string, double> parameters;

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
} // namespace

/** Documents go in as they are: a written design has megabytes, and hosts ask often. */
std::string stateToText (const SessionState& state)
{
    auto muted = nlohmann::ordered_json::array();

    for (int i = 0; i < maximumMutes; ++i)
        if (((state.mutes >> i) & 1U) != 0)
            muted.push_back (i + 1);

    const auto& design = state.focus->design;
    auto text = R"({"schema":")" + std::string (schema) + R"(","device":)" + state.device->text;
    text += R"(,"focus":)" + state.focus->text;

    // What is as ever is left out: such a state loads in versions that do not know of it.
    if (design != nullptr)
        text += R"(,"design":)" + design->text;

    text += R"(,"parameters":)" + nlohmann::ordered_json (state.parameters).dump();
    text += R"(,"muted_ceramics":)" + muted.dump();

    if (state.isGraphOpen)
        text += R"(,"open_graph":true)";

    if (state.following.isOn())
        text += R"(,"tracking":)" + followingToText (state.following);

    return text + "}";
}

SessionState readState (std::string_view text)
{
    const auto json = parseJson (text, "state");
    const JsonValue value (json, "state");
    value.requireSchema (schema);
    const auto state = value.object (
        { "schema", "device", "focus", "design", "parameters", "muted_ceramics", "open_graph", "tracking" });
    const auto openGraph = state.optional ("open_graph"), following = state.optional ("tracking");
    const auto device = state.required ("device"), focus = state.required ("focus"),
               parameters = state.required ("parameters");

    if (! parameters.isObject())
        parameters.fail ("must be an object of numbers");

    auto read = readFocusDocument (json["focus"], "state: focus");

    if (state.has ("design"))
        read.design = readDesignDocument (json["design"], "state: design");

    return { std::make_shared<const DeviceDocument> (readDeviceDocument (json["device"], "state: device")),
             std::make_shared<const FocusDocument> (std::move (read)),
             readParameters (parameters, json["parameters"]),
             readMutes (state.required ("muted_ceramics")),
             openGraph && openGraph->boolean(),
             following ? followingFromJson (*following) : FollowingSettings() };
}
} // namespace antinode
