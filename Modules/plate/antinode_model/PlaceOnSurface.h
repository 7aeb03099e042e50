#pragma once

#include "Surface.h"

#include <string>

namespace antinode
{
/** Refuses a y other than 0 where the surface is a line.
    @param where  how errors name the coordinate
    @throws InputError  one sentence [any] */
void requireOnLine (const Surface&, double y, const std::string& where);

/** Refuses a place that is not on a surface: beyond its extent, beside a line, in a hole.
    @param where  how errors name the place: "focus: target 1"
    @throws InputError  one sentence, with the places that are allowed [any] */
void requireOnSurface (const Surface&, double x, double y, const std::string& where);
} // namespace antinode
