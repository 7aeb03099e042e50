#include "DeviceState.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr double farthestValue = 1e12; // of a parameter: each cuts it to its own range
} // namespace

std::string deviceStateToText (const DeviceState& state, const char* schema)
{
    const nlohmann::ordered_json json { { "schema", schema },
                                        { "device", nlohmann::ordered_json::parse (state.device->text) },
                                        { "parameters", state.parameters } };
    return json.dump();
}

DeviceState readDeviceState (std::string_view text, const char* schema)
{
    const auto json = parseJson (text, "state");
    const JsonValue value (json, "state");
    value.requireSchema (schema);
    const auto state = value.object ({ "schema", "device", "parameters" });
    const auto device = state.required ("device"), parameters = state.required ("parameters");

    if (! device.isObject())
        device.fail ("must be a device");

    if (! parameters.isObject())
        parameters.fail ("must be an object of numbers");

    DeviceState read { std::make_shared<const DeviceDocument> (readDeviceDocument (json["device"], "state: device")),
                       {} };

    for (const auto& [key, ignored] : json["parameters"].items())
        read.parameters[key] = parameters.required (key).number ({ -farthestValue, farthestValue });

    return read;
}
} // namespace antinode
