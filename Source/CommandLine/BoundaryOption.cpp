#include "BoundaryOption.h"

#include <antinode_base/InputError.h>
#include <antinode_drawing/Drawing.h>
#include <antinode_library/Inputs.h>
#include <antinode_model/BoundedSurface.h>

#include <filesystem>
#include <variant>

namespace antinode
{
void addOutlineOption (CLI::App& command, std::string& outline)
{
    command
        .add_option ("--outline", outline,
                     "Where the surface ends: a plate by embedded name or .json file, or a drawing (.svg, .dxf)")
        ->type_name ("FILE");
}

bool isDrawingFile (const std::string& outline)
{
    const auto extension = std::filesystem::path (outline).extension();
    return extension == ".svg" || extension == ".dxf";
}

std::optional<SurfaceBoundary> boundaryFrom (const std::string& outline)
{
    if (outline.empty())
        return {};

    if (isDrawingFile (outline))
        return SurfaceBoundary { readOutlineFile (outline, {}), {} };

    const auto device = loadDevice (outline, {});
    const auto surface = deviceExtent (device);

    if (surface.kind == SurfaceKind::line || (! surface.boundary && std::holds_alternative<ModalModel> (device.body)))
        throw InputError ("--outline " + outline,
                          "is a device that does not say where a surface ends; allowed: a plate, or a drawing");

    return boundaryOf (surface);
}
} // namespace antinode
