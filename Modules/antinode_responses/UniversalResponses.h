#pragma once

#include "MeasuredResponse.h"

#include <antinode_universal/UniversalSets.h>

namespace antinode
{
/** The frequency responses of universal data sets: functions of type 4; if there is none, time records (type 1), which
   are taken as impulse responses and transformed. A point is the node of the response, a driver the node or entity of
   the reference; a direction against an axis changes the sign. Of several directions that of most responses is taken,
   and where nodes are (15, 2411) their places in the plane normal to it. Lengths and forces are divided by the factors
   of a 164 that stands in the file.
    @param source  how errors and remarks name the file
    @throws InputError  when there is neither
    [worker] Docs/FileFormats.md. */
MeasurementFile measurementFromUniversal (const std::vector<UniversalSet>&, const std::string& source);

/** Frequency responses as universal data sets in double precision: header, SI units, nodes from 1, and one 58b per
   point and reference: the driver is written as the reference, its point as node or its name as entity (ten characters;
   D1, D2 ... where they would not differ). Lines at which one is not finite are left out for all, responses without a
   finite line altogether.
    @throws InputError  when no line is finite
    [worker] */
std::vector<UniversalSet> responseSets (const FrequencyResponses&);
} // namespace antinode
