#pragma once

#include <antinode_base/ShowProgress.h>
#include <antinode_learning/DriftTrace.h>
#include <antinode_structure/DeviceDescription.h>

#include <functional>
#include <optional>

namespace antinode
{
/** How a drift is followed: sensors, and how far and how quickly the device may be off. */
struct FollowRequest
{
    Eigen::MatrixX2d places = Eigen::MatrixX2d (0, 2);         ///< Of the velocity sensors, m.
    int idleCeramic = 0;                                       ///< Whose current is heard, counted from 1; 0: none.
    double latency = 0, signalToNoise = 40;                    ///< ms, dB
    double window = 1, memory = 0.3;                           ///< s
    double largestJump = 2;                                    ///< Of all frequencies, %.
    double drift = 0.5, scatter = 0.1, damping = 10, gain = 5; ///< Standard deviations, %.
    std::optional<double> feedthrough; ///< The sensor's unit per V/s; none: as much as of modes.
    bool usesCache = true;
};

/** Gives what was recorded on a device by so many sensors. */
using ReadRecording = std::function<PlayedRecording (const ModalModel& known, Eigen::Index sensors)>;

/** A drift, and what it is a drift of. */
struct FollowedDevice
{
    DeviceDescription device;
    ModalModel nominal;     ///< As it was before, with modes beyond its own.
    Eigen::Index known = 0; ///< How many are its own.
    DriftTrace trace;
};

/** How the modes of a device drifted while something was played on it and recorded.
    @param progress  may be empty
    @throws InputError  as followRecording, and where there is no sensor
    [worker] Docs/Theory.md, section 7.7. */
FollowedDevice followOnDevice (const DeviceDescription&, const FollowRequest&, const ReadRecording&,
                               const ShowProgress& progress);
} // namespace antinode
