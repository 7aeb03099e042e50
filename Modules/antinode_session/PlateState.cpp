#include "PlateState.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr auto plateSchema = "antinode.plate/1";
constexpr double farthestPlateValue = 1e12; // of a parameter: each cuts it to its own range
} // namespace

std::string plateStateToText (const PlateState& state)
{
    const nlohmann::ordered_json json { { "schema", plateSchema },
                                        { "device", nlohmann::ordered_json::parse (state.device->text) },
                                        { "parameters", state.parameters } };
    return json.dump();
}

PlateState readPlateState (std::string_view text)
{
    const auto json = parseJson (text, "state");
    const JsonValue value (json, "state");
    value.requireSchema (plateSchema);
    const auto state = value.object ({ "schema", "device", "parameters" });
    const auto device = state.required ("device"), parameters = state.required ("parameters");

    if (! device.isObject())
        device.fail ("must be a device");

    if (! parameters.isObject())
        parameters.fail ("must be an object of numbers");

    PlateState read { std::make_shared<const DeviceDocument> (readDeviceDocument (json["device"], "state: device")),
                      {} };

    for (const auto& [key, ignored] : json["parameters"].items())
        read.parameters[key] = parameters.required (key).number ({ -farthestPlateValue, farthestPlateValue });

    return read;
}
} // namespace antinode
