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
enum class DeviceKind
{
    plate,
    beam,
    staple,
    modal
};

constexpr WordList<DeviceKind, 4> kindWords { { { "plate", DeviceKind::plate },
                                                { "beam", DeviceKind::beam },
                                                { "staple", DeviceKind::staple },
                                                { "modal", DeviceKind::modal } } };
} // namespace

DeviceDescription readDevice (const nlohmann::json& document, const std::string& source)
{
    const JsonValue device (document, source);
    device.requireSchema ("antinode.device/1");
    DeviceDescription result;

    switch (device.required ("kind").choice (kindWords))
    {
        case DeviceKind::plate:
            result.body = readPlate (device);
            break;
        case DeviceKind::beam:
            result.body = readBeam (device);
            break;
        case DeviceKind::staple:
            result.body = readStaple (device);
            break;
        case DeviceKind::modal:
            result.body = readModalModel (device);
            break;
    }

    result.requiresArming = readLimits (device.required ("limits")).requiresArming;
    result.name = device.required ("name").text (ranges::maximumNameBytes);

    if (const auto description = device.find ("description"))
        result.description = description->text (ranges::maximumDescriptionBytes, true);

    if (auto* const model = std::get_if<ModalModel> (&result.body))
        model->name = result.name;

    return result;
}
} // namespace antinode
