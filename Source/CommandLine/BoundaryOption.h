#pragma once

#include <antinode_model/Surface.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace antinode
{
/** The option --outline of commands that make modal devices. The text must live as long as the app. */
void addOutlineOption (CLI::App&, std::string& outline);

/** Whether the option names a drawing (.svg, .dxf), not a device. [any] */
bool isDrawingFile (const std::string& outline);

/** The boundary that the option names: that of a plate, or a drawing, of which no edge is held; none where it is
   empty.
    @throws InputError  where it cannot be read or has none [worker] */
std::optional<SurfaceBoundary> boundaryFrom (const std::string& outline);
} // namespace antinode
