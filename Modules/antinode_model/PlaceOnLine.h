#pragma once

#include "Surface.h"

#include <string>

namespace antinode
{
/** Refuses a y other than 0 where the surface is a line.
    @param where  how errors name the coordinate
    @throws InputError  one sentence [any] */
void requireOnLine (const Surface&, double y, const std::string& where);
} // namespace antinode
