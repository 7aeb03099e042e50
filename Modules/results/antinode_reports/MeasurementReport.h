#pragma once

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
} // namespace antinode
