#pragma once

#include "ResponseUnit.h"

#include <map>
#include <string>
#include <vector>

namespace antinode
{
/** One frequency response as a file has it: of one point to one driver, in the file's unit. N_f lines. */
struct MeasuredResponse
{
    std::string source;        ///< The file, for messages.
    std::string point, driver; ///< Names; empty where the file does not say.
    std::string driverPoint;   ///< Name of the point at which a force acts; empty where it is not known.
    ResponseUnit unit;
    Eigen::VectorXd frequencies; ///< N_f: Hz
    Eigen::VectorXcd values;     ///< N_f, motion per drive; NaN where not measured.
    double recordLength = 0;     ///< s, of the impulse response it was made from; 0 where it was none.
};

/** Places of points by their names, m. */
using PointPlaces = std::map<std::string, Eigen::Vector2d>;

/** What one file holds. */
struct MeasurementFile
{
    std::vector<MeasuredResponse> responses;
    PointPlaces places;
    std::vector<std::string> remarks; ///< What was assumed or left out, in plain words.
};

/** What the user says of responses; it goes before what files say. */
struct MeasurementOptions
{
    std::optional<ResponseUnit> response; ///< Quantity and factor of the motion.
    std::optional<ResponseUnit> drive;    ///< Kind and factor of the drive.
    PointPlaces places;
    std::vector<std::string> drivers; ///< Names in the order of the ceramics; empty: in the order of the files.
};

/** Responses of all files as one table of velocities. */
struct Measurement
{
    FrequencyResponses responses;
    std::vector<std::string> pointNames; ///< N_p
    bool hasPlaces = false;  ///< Whether the places of the points are known; else they are 1 mm apart on a line.
    double recordLength = 0; ///< s: of impulse responses; 0 where there were none.
    std::vector<std::string> remarks;
};

/** Puts the responses of several files together: converted to velocity per volt or newton (velocity where no file and no option says
    what it is, per volt), points and drivers numbered where they have no names, lines at 0 Hz left out. Points that are
    named by numbers stand in their order, drivers as in the first file where it has all of them, which is that of the channels. Where forces act at many points and few are measured, points and drivers change places,
    which reciprocity allows.
    @throws InputError  when frequencies, units or drives of two files do not fit together, or none has a response
    [worker] Docs/Theory.md, section 8.1. */
Measurement mergedResponses (const std::vector<MeasurementFile>&, const MeasurementOptions&);
} // namespace antinode
