#include "Follow.h"

#include "DeviceChecks.h"
#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_learning/LowerRate.h>
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
    DriftSettings settings;
    settings.spread.drift = request.drift;
    settings.spread.frequency = request.scatter;
    settings.spread.damping = request.damping;
    settings.spread.gain = request.gain;
    settings.spread.feedthrough = request.feedthrough.value_or (usualFeedthrough (model, sensors));
    settings.memory = request.memory;
    settings.largestJump = request.largestJump;
    return settings;
}

/** Recorded signals that were given as arrays. @throws InputError  where they do not fit the device */
PlayedRecording givenRecording (const FollowRequest& request, const ModalModel& model, Eigen::Index sensors)
{
    const auto check = [] (const char* name, const Eigen::MatrixXd& given, Eigen::Index wanted, const char* each)
    {
        if (given.rows() != wanted)
            throw InputError (name, "has " + std::to_string (given.rows())
                                        + " rows; allowed: " + std::to_string (wanted) + ", one per " + each);
    };
    check ("voltages_V", *request.voltages, model.actuators(), "ceramic");
    check ("signals", *request.signals, sensors, "sensor");
    const auto samples = std::min (request.voltages->cols(), request.signals->cols());
    return { *request.sampleRate,
             withLags (model, request.voltages->leftCols (samples), *request.sampleRate),
             request.signals->leftCols (samples),
             {},
             0 };
}

PlayedRecording recordingOf (const FollowRequest& request, const ModalModel& model)
{
    const auto sensors = sensorCount (request, model);
    const auto given = request.voltages.has_value() + request.signals.has_value() + request.sampleRate.has_value();

    if (request.recorded.empty() ? given != 3 : given != 0)
        throw InputError (
            "recorded",
            "is not given alone; allowed: a folder, or from Python voltages_V with signals and sample_rate_Hz");

    return request.recorded.empty() ? givenRecording (request, model, sensors)
                                    : readPlayedRecording (request.recorded, model, sensors, request.sensor);
}
} // namespace

std::vector<Field> fields (FollowRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000;
    const auto share = [&] (const char* option, double& value, double most, const char* text)
    { return Field (option, &value, text).in (percent).within (0, most); };
    std::vector<Field> all {
        Field ("device", &request.device, "Device before the drift: an embedded name or a .json file")
            .required()
            .positional(),
        Field ("--recorded", &request.recorded,
               "Folder with voltages.wav and with recorded.csv or recorded.wav of the sensors")
            .written ("FOLDER")
            .positional(),
        Field ("", &request.voltages, "Played voltages, instead of a folder: N_b x N_s, V").as ("voltages_V"),
        Field ("", &request.signals,
               "Recorded signals: N x N_s, velocities at the sensors, m/s, then the current of the idle ceramic")
            .as ("signals"),
        Field ("", &request.sampleRate, "Of both, Hz").as ("sample_rate_Hz").within (8000, 2e6),
        Field ("--sensors", &request.places, "Places of the velocity sensors").as ("sensors_mm").written ("POINTS.csv"),
        Field ("--idle-ceramic", &request.idleCeramic,
               "Ceramic that is not driven and whose current is the last channel, counted from 1; 0: none")
            .within (0, 4096),
        Field ("--latency-ms", &request.latency, "Latency of the recording, ms").in (milliseconds).within (0, 200),
        Field ("--snr-db", &request.signalToNoise, "Signal-to-noise ratio of the sensors, dB")
            .as ("snr_dB")
            .within (-20, 300),
        share ("--drift-percent", request.drift, 10, "Standard deviation of the drift common to all frequencies, %"),
        share ("--scatter-percent", request.scatter, 10,
               "Standard deviation of the individual drift of each frequency, %"),
        share ("--damping-percent", request.damping, 50, "Standard deviation of each damping ratio, %"),
        share ("--gain-percent", request.gain, 50, "Standard deviation of the gain of a sensor for each mode, %"),
        share ("--jump-percent", request.largestJump, 10, "Largest jump of all frequencies that is searched for, %"),
        Field ("--feedthrough", &request.feedthrough,
               "Standard deviation of the feedthrough of each voltage's slope to the sensors, in their unit per V/s")
            .within (0, 1)
            .by ("that of modes above those of the model"),
        Field ("--window-s", &request.window, "Length of a window, s").within (0, 60),
        Field ("--memory-s", &request.memory, "Memory of the slowest mode before each window, s").within (0, 10),
        cacheField (request.usesCache),
    };
    append (all, fields (request.sensor));
    return all;
}

FollowedDevice follow (const FollowRequest& request, const ShowProgress& progress)
{
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Modes of the device", 0);
    const auto known = solveDevice (request.device, {}, request.usesCache);
    checkKindOfPlaces (known, request.places, "sensor");
    auto recording = recordingOf (request, known);
    const auto wide = widened (request.device, known, recording.sampleRate, request.usesCache);
    auto nominal = modesWithin (wide.model, recording.sampleRate);
    const auto sensors = sensorsOf (request, nominal);
    recording.noise = noiseOfRecording (recording.signals, request.signalToNoise);
    recording.delay = request.latency;

    // A ceramic that listens is not driven, whatever its channel says.
    if (request.idleCeramic > 0)
        recording.voltages.row (request.idleCeramic - 1).setZero();

    auto trace = followRecording (nominal, sensors, recording, settingsOf (request, nominal, sensors), request.window,
                                  [&] (double share) { show ("Following", share); });
    const auto own = std::min (known.modes(), nominal.modes());
    return { request.device, std::move (nominal), own, std::move (trace) };
}
} // namespace antinode
