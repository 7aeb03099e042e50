#include "OutlineField.h"

#include <antinode_base/InputError.h>
#include <antinode_drawing/Drawing.h>
#include <antinode_library/Inputs.h>
#include <antinode_model/BoundedSurface.h>

#include <variant>

namespace antinode
{
Field outlineField (std::filesystem::path& outline)
{
    return Field ("--outline", &outline,
                  "Where the surface ends: a plate by embedded name or .json file, or a drawing (.svg, .dxf)")
        .written ("FILE");
}

bool isDrawingFile (const std::filesystem::path& outline)
{
    const auto extension = outline.extension();
    return extension == ".svg" || extension == ".dxf";
}

std::optional<SurfaceBoundary> boundaryFrom (const std::filesystem::path& outline)
{
    if (outline.empty())
        return {};

    if (isDrawingFile (outline))
        return SurfaceBoundary { readOutlineFile (outline.string(), {}), {} };

    const auto device = loadDevice (outline.string(), {});
    const auto surface = deviceExtent (device);

    if (surface.kind == SurfaceKind::line || (! surface.boundary && std::holds_alternative<ModalModel> (device.body)))
        throw InputError ("--outline " + outline.string(),
                          "is a device that does not say where a surface ends; allowed: a plate, or a drawing");

    return boundaryOf (surface);
}
} // namespace antinode
