#pragma once

#include "ResponseUnit.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** One frequency response of a file: of one point to one reference, in the file's unit. N_f lines. */
struct MeasuredResponse
{
    std::string source;           ///< The file, for messages.
    std::string point, reference; ///< Names; empty if the file does not say.
    std::string referencePoint;   ///< Name of the point at which a force acts; empty if it is not known.
    ResponseUnit unit;
    std::shared_ptr<const Eigen::VectorXd> frequencies =
        std::make_shared<const Eigen::VectorXd>(); ///< N_f: Hz. Responses of one file share theirs.
    Eigen::VectorXcd values;                       ///< N_f, motion per drive; NaN where not measured.
    double recordLength = 0; ///< s, of the impulse response it was made from; 0 where it was none.
    double windowDecay = 0;  ///< 1/s, of an exponential window over drive and motion that the file tells; 0: none.
};

/** Frequencies for a further response of a file: those of the last one where they are the same. [worker] */
std::shared_ptr<const Eigen::VectorXd> sharedFrequencies (Eigen::VectorXd,
                                                          const std::vector<MeasuredResponse>& earlier);

/** Places of points by their names, m. */
using PointPlaces = std::map<std::string, Eigen::Vector2d>;

/** The content of one file. */
struct MeasurementFile
{
    std::vector<MeasuredResponse> responses;
    PointPlaces places;
    std::vector<std::string> remarks; ///< What was assumed or left out, as sentences.
};

/** The user's statements about responses; they override the files. */
struct MeasurementOptions
{
    std::optional<ResponseUnit> response; ///< Quantity and factor of the motion.
    std::optional<ResponseUnit> drive;    ///< Kind and factor of the drive.
    PointPlaces places;
    std::vector<std::string> references; ///< Names in the order of the ceramics; empty: in the order of the files.
};

/** Responses of all files as one table of velocities. */
struct Measurement
{
    FrequencyResponses responses;
    std::vector<std::string> pointNames; ///< N_p
    bool hasPlaces = false;  ///< Whether the positions of the points are known; else they are 1 mm apart on a line.
    double recordLength = 0; ///< s: of impulse responses; 0 where there were none.
    double windowDecay = 0;  ///< 1/s: of the exponential window that the files tell; 0 where there was none.
    std::vector<std::string> remarks;
};

/** Puts the responses of several files together: converted to velocity per volt or newton (where no file and no option
   says what was measured, numbers as they are; per volt where none says what excites), points and references numbered
   where they have no names, lines at 0 Hz left out. Points that are named by numbers stand in their order, references
   as in the first file where it has all of them, which is that of the channels. Where forces act at many points and few
   are measured, points and references change places, which reciprocity allows.
    @throws InputError  when frequencies, units or drives of two files do not fit together, or none has a response
    [worker] Docs/Theory.md, section 8.1. */
Measurement mergedResponses (const std::vector<MeasurementFile>&, const MeasurementOptions&);

/** Gives the points of a measurement their places by their names, those of the options before those of files; 1 mm
   apart on a line, with a remark, where not each has a place of its own. A line in another direction comes to lie along
   x.
    @throws InputError  when the options have places, but not for all points
    [worker] Docs/FileFormats.md. */
void placePoints (const std::vector<MeasurementFile>&, const MeasurementOptions&, Measurement&);

/** All responses of several files with names of point and reference. Points without names are numbered within their
   file where it has several for a reference; what is then not named is numbered by the files where these differ in
   nothing else, else it is 1. [worker] Docs/FileFormats.md. */
std::vector<MeasuredResponse> namedResponses (const std::vector<MeasurementFile>&);
} // namespace antinode
