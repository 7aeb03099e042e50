#include "BoundaryOption.h"

#include <antinode_base/InputError.h>
#include <antinode_drawing/Drawing.h>
#include <antinode_library/Inputs.h>

#include <filesystem>

namespace antinode
{
void addOutlineOption (CLI::App& command, std::string& outline)
{
    command
        .add_option ("--outline", outline,
                     "Where the surface ends: a plate with an outline by embedded name or .json file, or a drawing "
                     "(.svg, .dxf)")
        ->type_name ("FILE");
}

std::optional<SurfaceBoundary> boundaryFrom (const std::string& outline)
{
    if (outline.empty())
        return {};

    const auto extension = std::filesystem::path (outline).extension();

    if (extension == ".svg" || extension == ".dxf")
        return SurfaceBoundary { readOutlineFile (outline, {}), {} };

    auto surface = deviceExtent (loadDevice (outline, {}));

    if (! surface.boundary)
        throw InputError ("--outline " + outline, "is a device without an outline; allowed: one with it, or a drawing");

    return std::move (surface.boundary);
}
} // namespace antinode
