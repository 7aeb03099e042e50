#pragma once

#include "Report.h"

#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <string>

namespace antinode
{
/** The report of a measurement with figures. [worker] */
ReportPage measurementReport (const SurfaceMeasurement&, const ExcitationSheet&);

/** The same as report.html in a folder. @throws InputError  where it cannot be written [worker] */
void writeMeasurementReport (const std::string& folder, const SurfaceMeasurement&, const ExcitationSheet&);

/** The same in a few lines on the terminal. */
void printMeasurement (const SurfaceMeasurement&, const ExcitationSheet&);
} // namespace antinode
