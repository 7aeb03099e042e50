#pragma once

#include "MatlabFile.h"
#include "MeasuredResponse.h"
#include "UniversalFile.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** One channel of a recording. */
struct RecordedSignal
{
    bool isForce = false;
    std::string point;    ///< Its point; of a force the point that is hit. Empty if the file does not say.
    int direction = 0;    ///< +-1, 2, 3 along and against x, y, z; 0 if it is not known.
    ResponseUnit unit;    ///< What a sample of 1 stands for: of a motion, or of a force.
    double fullScale = 0; ///< The value at which the channel ends, in samples; 0 if it is not known.
    Eigen::VectorXd samples;
};

/** The time records of force and motion that were recorded together. */
struct RecordedSignals
{
    std::string source;
    double sampleRate = 0; ///< Hz
    std::vector<RecordedSignal> signals;
    std::vector<std::string> remarks; ///< What was assumed, as sentences.
};

/** All recordings of a file, and the places of its points. */
struct RecordingFile
{
    std::vector<RecordedSignals> recordings;
    PointPlaces places;
};

/** A channel as a user names it: "force", "force:7" (which hits point 7), "3", "3:x", "3:-z".
    @param where  how errors name it
    @throws InputError  when it is no such name [any] */
RecordedSignal namedChannel (const std::string& name, const std::string& where);

/** Time records of a file of any kind that is read.

    WAV: the first channel is the force, the others are points 1, 2, ...; text: a column of times, then those of force
   and motion by their headings ("force (N)", "P3 x (m/s^2)"), else in the order of a WAV file; MATLAB: a vector of
   times `t` or `time`, or a rate `fs` or an interval `dt`, a vector `force` and an array with a name of a motion
   (acceleration, velocity, response, ...); universal: functions of type 1, a force by its quantity or unit; the n-th
   records of all channels belong together. Words such as point3 and driver5 in the name of a file name point and hit
   point.
    @param channels  names of the channels in their order, of WAV and text files; empty: as above
    @throws InputError  source, place, what is wrong
    [worker] Docs/FileFormats.md. */
RecordingFile decodeRecordings (std::string_view bytes, const std::string& source,
                                const std::vector<std::string>& channels);

/** The same of a file of at most 4 GiB. @throws InputError  also when it cannot be read [worker] */
RecordingFile readRecordings (const std::filesystem::path&, const std::vector<std::string>& channels);

/** As decodeRecordings. @throws InputError  where force, motion or time are missing or do not fit together [worker] */
RecordingFile recordingsFromMatlab (const std::vector<MatlabVariable>&, const std::string& source);

/** The same. [worker] */
RecordingFile recordingsFromUniversal (const std::vector<UniversalSet>&, const std::string& source);
} // namespace antinode
