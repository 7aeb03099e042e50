#include "DeviceTemplates.h"

#include "CeramicEdits.h"
#include "DeviceEdits.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace antinode
{
namespace
{
using nlohmann::json;

/** A glass plate without ceramics, held as it is said. */
json glassPlate (const json& shape, const json& edges)
{
    json device { { "schema", "antinode.device/1" },
                  { "name", "new" },
                  { "kind", "plate" },
                  { "thickness_mm", 1 },
                  { "material", "glass" },
                  { "edges", edges },
                  { "quality_factor", 40 },
                  { "ceramics", json::array() },
                  { "limits", { { "voltage_V", 100 }, { "full_scale_V", 100 } } } };
    device.update (shape);
    return device;
}

constexpr double fromEdge = 6; // mm

DrawnCeramic disc (double diameter)
{
    return { CeramicShape::disc, Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant (diameter) };
}

json withTwoRows (json device, const DrawnCeramic& kind, int count)
{
    for (const auto side : { DeviceSide::bottom, DeviceSide::top })
        device = withRow (std::move (device), kind, 0, side, count, fromEdge);

    return device;
}

json silicone()
{
    return supportJson (usualSupports().back());
}

json rectangleTemplate()
{
    const json edges {
        { "left", silicone() }, { "right", silicone() }, { "bottom", silicone() }, { "top", silicone() }
    };
    return withTwoRows (glassPlate ({ { "length_x_mm", 160 }, { "length_y_mm", 100 } }, edges), disc (12), 5);
}

json roundedTemplate()
{
    const json outline { { "shape", "rectangle" }, { "size_x_mm", 160 }, { "size_y_mm", 100 }, { "radius_mm", 12 } };
    return withTwoRows (glassPlate ({ { "outline", outline } }, silicone()), disc (12), 4);
}

json discTemplate()
{
    const json outline { { "shape", "circle" }, { "diameter_mm", 160 } };
    return withRing (glassPlate ({ { "outline", outline } }, silicone()), disc (16), 0, 8, fromEdge);
}

/** A device of the library, without what is said of that one alone. */
json ofLibrary (const char* name)
{
    auto device = loadDocument (LibraryKind::device, name);
    device.erase ("description");
    return device;
}

json beamTemplate()
{
    return ofLibrary ("beam");
}

json stapleTemplate()
{
    return ofLibrary ("staple");
}

json phoneTemplate()
{
    return ofLibrary ("phone");
}

constexpr std::array<DeviceTemplate, 6> templates { { { "beam", beamTemplate },
                                                      { "staple", stapleTemplate },
                                                      { "rectangle", rectangleTemplate },
                                                      { "rounded rectangle", roundedTemplate },
                                                      { "disc", discTemplate },
                                                      { "phone", phoneTemplate } } };
} // namespace

std::span<const DeviceTemplate> deviceTemplates()
{
    return templates;
}

json newDevice (const std::string& name)
{
    const auto found = std::find_if (templates.begin(), templates.end(),
                                     [&] (const DeviceTemplate& each) { return name == each.name; });

    if (found == templates.end())
        throw InputError ("new device", "'" + name + "' is no template");

    return withName (found->make(), "new " + name);
}
} // namespace antinode
