#pragma once

#include <antinode_measurement/SurfaceMeasurement.h>

#include <string>
#include <string_view>

namespace antinode
{
/** What was measured at one point as a universal file: a 58b of type 4 a ceramic, and of type 6, the coherence, where it is known. Node k
    is point k of the measurement, so that the files of all points together are a measurement.
    @param point  one at which all ceramics have had their turn
    [worker] Docs/FileFormats.md. */
std::string encodePoint (const SurfaceMeasurement&, Eigen::Index point);

/** Puts what such a file holds back into its measurement.
    @param source  how errors name it
    @throws InputError  when it is no such file, or belongs to another excitation
    [worker] */
void restorePoint (SurfaceMeasurement&, Eigen::Index point, std::string_view bytes, const std::string& source);
} // namespace antinode
