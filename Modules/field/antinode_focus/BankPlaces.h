#pragma once

#include "FocusDescription.h"

#include <antinode_model/Surface.h>

#include <utility>
#include <vector>

namespace antinode
{
/** Places for the foci of a bank: along the centre line of a beam's surface from left to right, or row by row from the
   lower left corner over a plate, in a grid whose fields are about as high as wide.
    @param count   less than 1: none
    @param margin  m, kept from every edge; at most a third of the side is
    @return        x, y in m
    [any] */
std::vector<std::pair<double, double>> bankPlaces (const Surface&, int count, double margin);

/** A focus with its first target at another place, x, y in m; the others keep their distance to it. [any] */
FocusDescription movedTo (FocusDescription, double x, double y);
} // namespace antinode
