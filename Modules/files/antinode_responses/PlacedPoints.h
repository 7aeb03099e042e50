#pragma once

#include "MeasuredResponse.h"

namespace antinode
{
/** Gives the points of a measurement their places by their names, those of the options before those of files; 1 mm
   apart on a line, with a remark, where not each has a place of its own. A line in another direction comes to lie along
   x.
    @throws InputError  when the options have places, but not for all points
    [worker] Docs/FileFormats.md. */
void placePoints (const std::vector<MeasurementFile>&, const MeasurementOptions&, Measurement&);
} // namespace antinode
