#include "DeviceFile.h"

#include "LimitsReader.h"
#include "ModalReader.h"
#include "StructureReader.h"

#include <antinode_text/JsonReader.h>
#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
namespace
{
using DeviceBody = decltype (DeviceDescription::body);

constexpr WordList<DeviceBody (*) (const JsonValue&), 4> deviceKinds {
    { { "plate",
        [] (const JsonValue& device) -> DeviceBody
        { return std::visit ([] (auto plate) -> DeviceBody { return plate; }, readPlate (device)); } },
      { "beam", [] (const JsonValue& device) -> DeviceBody { return readBeam (device); } },
      { "staple", [] (const JsonValue& device) -> DeviceBody { return readStaple (device); } },
      { "modal", [] (const JsonValue& device) -> DeviceBody { return readModalModel (device); } } }
};
} // namespace

DeviceDescription readDevice (const nlohmann::json& document, const std::string& source)
{
    const JsonValue device (document, source);
    device.requireSchema ("antinode.device/1");
    DeviceDescription result;
    result.body = device.required ("kind").choice (deviceKinds) (device);
    result.requiresArming = readLimits (device.required ("limits")).requiresArming;
    result.name = device.required ("name").text (ranges::maximumNameBytes);

    if (const auto description = device.find ("description"))
        result.description = description->text (ranges::maximumDescriptionBytes, true);

    if (auto* const model = std::get_if<ModalModel> (&result.body))
        model->name = result.name;

    return result;
}
} // namespace antinode
