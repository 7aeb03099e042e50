#pragma once

#include "MeasuredResponse.h"
#include "UniversalFile.h"

namespace antinode
{
/** The frequency responses of universal data sets: functions of type 4; if there is none, time records (type 1), which
   are taken as impulse responses and transformed. A point is the node of the response, a driver the node or entity of
   the reference; a direction against an axis changes the sign. Of several directions that of most responses is taken,
   of equally many that of a force, else the last one; and where nodes are (15, 2411) their places in the plane normal
   to it. Lengths and forces are divided by the factors of a 164 that stands in the file.
    @param source  how errors and remarks name the file
    @throws InputError  when there is neither
    [worker] Docs/FileFormats.md. */
MeasurementFile measurementFromUniversal (const std::vector<UniversalSet>&, const std::string& source);

/** What a number on an axis stands for, of a motion or a force: by the unit that it names, else by the code of its
    quantity in the file's units. [any] */
std::optional<ResponseUnit> universalUnit (const UniversalAxis&, const UniversalUnits&);

/** Whether a function is a force, by unit or quantity. [any] */
bool isForceRecord (const UniversalFunction&, const UniversalUnits&);

/** The factors by which the file's lengths and forces are divided. [any] */
UniversalUnits universalUnits (const std::vector<UniversalSet>&);

/** Places of nodes in the plane normal to an axis, m. @param normal  1 to 3: x to z; else z [worker] */
PointPlaces universalPlaces (const std::vector<UniversalSet>&, int normal);

/** The text line of a function that tells the decay rate of an exponential window over drive and motion, 1/s. [any] */
std::string windowDecayLine (double decay);

/** Frequency responses as universal data sets in double precision: header, SI units, nodes from 1, and one 58b per
   point and reference: the driver is written as the reference, its point as node or its name as entity (ten characters;
   D1, D2 ... where they would not differ). Lines at which one is not finite are left out for all, responses without a
   finite line altogether.
    @throws InputError  when no line is finite
    [worker] */
std::vector<UniversalSet> responseSets (const FrequencyResponses&);

/** The coherence that belongs to a response. @param values  as many as the response has [any] */
UniversalFunction coherenceSet (UniversalFunction response, const Eigen::VectorXd& values);
} // namespace antinode
