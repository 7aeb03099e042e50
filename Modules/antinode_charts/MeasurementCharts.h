#pragma once

#include "Chart.h"

#include <antinode_measurement/SurfaceMeasurement.h>

namespace antinode
{
/** The effective velocity of all points over frequency, a curve a ceramic; of many ceramics the strongest ones. [worker] */
LineChart responseChart (const SurfaceMeasurement&);

/** The coherence over frequency in the mean over the points, a curve a ceramic; the same ceramics. [worker] */
LineChart coherenceChart (const SurfaceMeasurement&);

/** Signal to noise in dB, from the mean coherence: a row a ceramic, a column a point. [worker] */
HeatMap signalToNoiseChart (const SurfaceMeasurement&);
} // namespace antinode
