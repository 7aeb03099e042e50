#include "FollowOnDevice.h"

#include "FocusOnDevice.h"
#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_learning/LowerRate.h>
#include <antinode_library/Library.h>
#include <antinode_model/ShapesAtPlaces.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
Eigen::Index sensorCount (const FollowRequest& request, const ModalModel& model)
{
    if (request.idleCeramic < 0 || request.idleCeramic > model.actuators())
        throw InputError ("--idle-ceramic", "is " + std::to_string (request.idleCeramic) + "; allowed: 1 to "
                                                + std::to_string (model.actuators()));

    const auto count = request.places.rows() + (request.idleCeramic > 0 ? 1 : 0);

    if (count == 0)
        throw InputError ("follow", "has no sensor; allowed: --sensors, --idle-ceramic or both");

    return count;
}

std::vector<Sensor> sensorsOf (const FollowRequest& request, const ModalModel& model)
{
    std::vector<Sensor> sensors;
    const auto shapes = shapesAtPlaces (model, request.places);

    for (Eigen::Index m = 0; m < shapes.rows(); ++m)
        sensors.push_back ({ shapes.row (m) });

    // By reciprocity an idle ceramic's current.
    if (request.idleCeramic > 0)
        sensors.push_back ({ model.participation.col (request.idleCeramic - 1).transpose() });

    return sensors;
}

DriftSettings settingsOf (const FollowRequest& request, const ModalModel& model, const std::vector<Sensor>& sensors)
{
    constexpr double percent = 100;
    DriftSettings settings;
    settings.spread.drift = request.drift / percent;
    settings.spread.frequency = request.scatter / percent;
    settings.spread.damping = request.damping / percent;
    settings.spread.gain = request.gain / percent;
    settings.spread.feedthrough = request.feedthrough.value_or (usualFeedthrough (model, sensors));
    settings.memory = request.memory;
    settings.largestJump = request.largestJump / percent;
    return settings;
}
} // namespace

FollowedDevice followOnDevice (const DeviceDescription& device, const FollowRequest& request,
                               const ReadRecording& readRecording, const ShowProgress& progress)
{
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Modes of the device", 0);
    const auto known = solveDevice (device, {}, request.usesCache);
    checkKindOfPlaces (known, request.places, "sensor");
    auto recording = readRecording (known, sensorCount (request, known));
    const auto wide =
        wideOf (device, known, { Reconstruction::bandLimited, recording.sampleRate }, request.usesCache).model;
    auto nominal = modesWithin (wide, recording.sampleRate);
    const auto sensors = sensorsOf (request, nominal);
    recording.noise = noiseOfRecording (recording.signals, request.signalToNoise);
    recording.delay = request.latency / 1000;

    // A ceramic that listens is not driven, whatever its channel says.
    if (request.idleCeramic > 0)
        recording.voltages.row (request.idleCeramic - 1).setZero();

    auto trace = followRecording (nominal, sensors, recording, settingsOf (request, nominal, sensors), request.window,
                                  [&] (double share) { show ("Following", share); });
    const auto own = std::min (known.modes(), nominal.modes());
    return { device, std::move (nominal), own, std::move (trace) };
}
} // namespace antinode
