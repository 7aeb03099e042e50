#include "DeviceState.h"

#include "FollowingState.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
constexpr double farthestValue = 1e12; // of a parameter: each cuts it to its own range

std::shared_ptr<const FocusDocument> readKeptFocus (const JsonObject& state, const nlohmann::json& json)
{
    if (! state.has ("focus") && ! state.has ("design"))
        return nullptr;

    state.required ("focus");
    auto read = readFocusDocument (json["focus"], "state: focus");

    if (state.has ("design"))
        read.design = readDesignDocument (json["design"], "state: design");

    return std::make_shared<const FocusDocument> (std::move (read));
}
} // namespace

std::string deviceStateToText (const DeviceState& state, const char* schema)
{
    auto text = R"({"schema":")" + std::string (schema) + R"(","device":)" + state.device->text;

    // Without a focus or a sensor such a state loads in versions that do not know of it.
    if (state.focus != nullptr)
        text += R"(,"focus":)" + state.focus->text;

    if (state.focus != nullptr && state.focus->design != nullptr)
        text += R"(,"design":)" + state.focus->design->text;

    if (state.following.isOn())
        text += R"(,"tracking":)" + followingToText (state.following);

    return text + R"(,"parameters":)" + nlohmann::ordered_json (state.parameters).dump() + "}";
}

DeviceState readDeviceState (std::string_view text, const char* schema)
{
    const auto json = parseJson (text, "state");
    const JsonValue value (json, "state");
    value.requireSchema (schema);
    const auto state = std::string_view (schema) == touchSchema
                           ? value.object ({ "schema", "device", "focus", "design", "tracking", "parameters" })
                           : value.object ({ "schema", "device", "parameters" });
    const auto device = state.required ("device"), parameters = state.required ("parameters");

    if (! device.isObject())
        device.fail ("must be a device");

    if (! parameters.isObject())
        parameters.fail ("must be an object of numbers");

    DeviceState read { std::make_shared<const DeviceDocument> (readDeviceDocument (json["device"], "state: device")),
                       {},
                       readKeptFocus (state, json),
                       state.has ("tracking") ? followingFromJson (state.required ("tracking")) : FollowingSettings() };

    for (const auto& [key, ignored] : json["parameters"].items())
        read.parameters[key] = parameters.required (key).number ({ -farthestValue, farthestValue });

    return read;
}
} // namespace antinode
