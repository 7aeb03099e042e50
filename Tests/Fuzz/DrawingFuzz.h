#pragma once

#include "Fuzz.h"

#include <antinode_outline/Drawing.h>

#include <cmath>

namespace antinode::test
{
/** Reads a drawing; what comes of it has to be an outline. */
inline void fuzzDrawing (std::string_view bytes)
{
    DrawingChoice choice;
    choice.unit = ! bytes.empty() && bytes.back() == ' ' ? 1e-3 : 0;
    const auto outline = outlineFromDrawing (bytes, "file", choice);
    require (areaOf (outline) > 0 && std::isfinite (areaOf (outline)));
    require (extentOf (outline).size().allFinite());
}
} // namespace antinode::test
