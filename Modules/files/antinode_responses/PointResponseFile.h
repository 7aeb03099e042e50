#pragma once

#include <antinode_measurement/SurfaceMeasurement.h>

#include <string>
#include <string_view>

namespace antinode
{
/** The results at one point as a universal file: one 58b of type 4 per ceramic, and of type 6, the coherence, if known.
   Node k is point k of the measurement, so that the files of all points together are a measurement.
    @param point  one at which all ceramics have run
    [worker] Docs/FileFormats.md. */
std::string encodePoint (const SurfaceMeasurement&, Eigen::Index point);

/** Restores the content of such a file in its measurement.
    @param source  how errors name it
    @throws InputError  when it is no such file, or belongs to another excitation
    [worker] */
void restorePoint (SurfaceMeasurement&, Eigen::Index point, std::string_view bytes, const std::string& source);
} // namespace antinode
