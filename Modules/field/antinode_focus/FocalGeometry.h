#pragma once

#include "FieldPeak.h"

#include <vector>

namespace antinode
{
/** Whether a place lies in none of the spots; their boundaries are outside. @param isLine  y does not count [any] */
bool liesOutside (const std::vector<FocalSpot>&, bool isLine, double x, double y);

/** A place on the boundary of a spot. @param angle  rad [any] */
FieldPeak placeOnBoundary (const FocalSpot&, double angle);
} // namespace antinode
