#include "TrackMemory.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <cmath>

namespace antinode
{
namespace
{
constexpr double mostBytes = 1 << 30; // of memory
constexpr double byNumber = sizeof (double);

double tableBytes (const ModalModel& model, const WaveformsDescription& description)
{
    double places = 0;

    for (const auto& point : touchedPoints (description))
        places += static_cast<double> (PathShapes::placesAlong (point));

    return byNumber * places * static_cast<double> (model.coordinates());
}
} // namespace

TrackBytes trackBytes (const ModalModel& model, const WaveformsDescription& description, const TrackSpan& span,
                       const TouchedNodes& touched)
{
    constexpr double signalsKept = 8, copiesPlayed = 3, copiesOfNodes = 3;
    const auto points = static_cast<double> (description.tracks.size() + description.silent.size());
    const auto nodes = static_cast<double> (touched.shapes().rows());
    const auto stages = static_cast<double> (touched.stages());
    const auto actuators = static_cast<double> (model.actuators());
    const auto moving = nodes > points ? copiesOfNodes * nodes : 0;
    const auto inLines = nodes * actuators + stages * points * points + actuators + signalsKept * points + moving;
    const auto inWindow = actuators * (signalsKept + copiesPlayed * static_cast<double> (span.factor));
    return { byNumber * (static_cast<double> (span.length) * inLines + static_cast<double> (span.window) * inWindow),
             tableBytes (model, description) };
}

bool isWithinMemory (TrackBytes bytes)
{
    return bytes.sum() <= mostBytes;
}

void requireTrackMemory (TrackBytes bytes, double seconds)
{
    if (! isWithinMemory (bytes))
        throw InputError ("waveforms", "last " + inWords (seconds) + " s, which needs "
                                           + inWords (bytes.sum() / mostBytes) + " GiB; allowed: 1 GiB, about "
                                           + inWords (std::floor (seconds * (mostBytes - bytes.tables) / bytes.samples))
                                           + " s with this device and rate");
}

void requirePathMemory (const ModalModel& model, const WaveformsDescription& description)
{
    const auto bytes = tableBytes (model, description);

    if (bytes > mostBytes)
        throw InputError ("waveforms",
                          "have paths that need " + inWords (bytes / mostBytes) + " GiB; allowed: 1 GiB, about "
                              + inWords (std::floor (100 * mostBytes / bytes)) + " % of their length with this device");
}
} // namespace antinode
