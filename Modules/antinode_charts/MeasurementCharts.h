#pragma once

#include "Chart.h"

#include <antinode_measurement/SurfaceMeasurement.h>

namespace antinode
{
/** The RMS velocity of all points over frequency, one curve per ceramic; of many ceramics the strongest ones. [worker]
 */
LineChart responseChart (const SurfaceMeasurement&);

/** The coherence over frequency, averaged over the points, one curve per ceramic; the same ceramics. [worker] */
LineChart coherenceChart (const SurfaceMeasurement&);

/** The signal-to-noise ratio in dB, from the mean coherence: one row per ceramic, one column per point. [worker] */
HeatMap signalToNoiseChart (const SurfaceMeasurement&);
} // namespace antinode
