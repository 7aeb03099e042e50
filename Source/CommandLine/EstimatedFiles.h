#pragma once

#include "SensorOptions.h"

#include <antinode_documents/ExcitationFile.h>
#include <antinode_measurement/AveragedSpectra.h>
#include <antinode_measurement/SurfaceMeasurement.h>

#include <string>
#include <vector>

namespace antinode
{
/** Recordings of an excitation, and what their channels are. */
struct RecordingOptions
{
    std::vector<std::string> files; ///< WAV files, each of one or more points, in the order of the points.
    std::string pointsFile;         ///< Places; empty: 1 mm apart on a line.
    SensorOptions sensor;
    int syncChannel = -1;          ///< Counted from 1; 0: none, -1: the last one.
    int referenceChannel = 0;      ///< Counted from 1; 0: none.
    double referenceFullScale = 1; ///< V
    double latency = 0;            ///< ms
    ResponseEstimator estimator = ResponseEstimator::h1;
};

/** "h1", "h2" or "hv"; other words are h1. [any] */
ResponseEstimator estimatorNamed (const std::string&);

/** Responses from recordings of an excitation.
    @throws InputError  for files that cannot be read or do not fit the excitation, and without a sensitivity
    [worker] Docs/Theory.md, section 8.9. */
SurfaceMeasurement estimateResponses (const ExcitationSheet&, const RecordingOptions&);

/** The universal file of a measurement. [worker] Docs/FileFormats.md. */
std::string measurementText (const SurfaceMeasurement&);
} // namespace antinode
