#pragma once

#include "Chart.h"
#include "Report.h"

#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/HammerHits.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <vector>

namespace antinode
{
/** The report of a measurement with figures. [worker] */
ReportPage measurementReport (const SurfaceMeasurement&, const ExcitationSheet&);

/** The report of a test with a hammer: its hits, the spectrum of their force, responses and coherences.
    @param measured  responses to a force, and their coherences
    [worker] Docs/Theory.md, section 8.11. */
ReportPage hammerReport (const std::vector<HammerRecording>&, const HammerTest&, const SurfaceMeasurement& measured);

/** The measurement in a few lines on the terminal. */
void printMeasurement (const SurfaceMeasurement&, const ExcitationSheet&);

/** The RMS velocity of all points over frequency, one curve per reference: a ceramic, or a place of the hammer. Of many
    references the strongest ones. [worker] */
LineChart responseChart (const SurfaceMeasurement&);

/** The coherence over frequency, averaged over the points, one curve per reference; the same references. [worker] */
LineChart coherenceChart (const SurfaceMeasurement&);

/** The signal-to-noise ratio in dB, from the mean coherence: one row per reference, one column per point.
    [worker] */
HeatMap signalToNoiseChart (const SurfaceMeasurement&);

/** The spectrum of a hammer's force in dB of its largest line, the lines that are used as a span.
    @param magnitude  as forceMagnitude()
    @param spacing    of its lines, Hz
    [worker] */
LineChart forceChart (const Eigen::VectorXd& magnitude, double spacing, const Eigen::VectorXd& usedFrequencies);
} // namespace antinode
