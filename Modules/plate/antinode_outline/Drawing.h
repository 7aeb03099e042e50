#pragma once

#include "Outline.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** What of a drawing is the outline, and what the drawing may not say. */
struct DrawingChoice
{
    std::string layer;       ///< A layer, group or element by its name or id; empty: all that is visible.
    double unit = 0;         ///< m of one unit of the drawing; 0: what the drawing says.
    double joint = 1e-5;     ///< m: how far ends may lie apart that belong together.
    double deviation = 1e-6; ///< m: how far arcs may lie from the free curve for which they stand.
};

/** The outline that an SVG or DXF drawing shows, in m, y upwards: its closed paths, loose lines and arcs being joined;
   the largest is the outer one, the others are holes. The origin is that of a DXF drawing, and the lower left corner of
   an SVG's page. Each line, arc or curve that is drawn is an edge of its own; they count from the outer path on.
    @param source  how errors name it
    @throws InputError  source, what is wrong, where, what is allowed
    [worker] Docs/FileFormats.md, Docs/Design/outlines.md */
Outline outlineFromDrawing (std::string_view bytes, const std::string& source, const DrawingChoice&);

/** The same, of a file. @throws InputError  as well where it cannot be read [worker] */
Outline readOutlineFile (const std::filesystem::path&, const DrawingChoice&);
} // namespace antinode
