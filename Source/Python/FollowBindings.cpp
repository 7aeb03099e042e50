#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Places.h"
#include "Recordings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/FollowFiles.h>
#include <CommandLine/FollowOnDevice.h>
#include <CommandLine/LearnFiles.h>
#include <antinode_base/InputError.h>
#include <antinode_engine/LagFilters.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace antinode
{
namespace
{
namespace py = pybind11;

constexpr double inPpm = 1e6, inPercent = 100;

using Followed = std::shared_ptr<FollowedDevice>;

/** Recorded signals, as arrays. @throws InputError  where they do not fit the device */
PlayedRecording fitting (PlayedRecording recording, const ModalModel& model, Eigen::Index sensors)
{
    const auto check = [] (const char* name, Eigen::Index rows, Eigen::Index wanted, const char* each)
    {
        if (rows != wanted)
            throw InputError (name, "has " + std::to_string (rows) + " rows; allowed: " + std::to_string (wanted)
                                        + ", one per " + each);
    };
    check ("voltages_V", recording.voltages.rows(), model.actuators(), "ceramic");
    check ("signals", recording.signals.rows(), sensors, "sensor");
    recording.voltages = withLags (model, recording.voltages, recording.sampleRate);
    return recording;
}

Followed followBy (const DeviceValue& device, FollowRequest request, const PlacePairs& sensors,
                   const ReadRecording& recording, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();

    if (! sensors.empty())
        request.places = placesOf (sensors, "sensors_mm");

    return work.run (
        [&]
        { return std::make_shared<FollowedDevice> (followOnDevice (device.description, request, recording, show)); });
}

Followed followFolder (const DeviceValue& device, const FollowRequest& request, const PlacePairs& sensors,
                       const std::string& folder, const SensorOptions& sensor, py::object progress)
{
    return followBy (
        device, request, sensors,
        [&] (const ModalModel& model, Eigen::Index count)
        { return readPlayedRecording (folder, model, count, sensor); },
        std::move (progress));
}

Followed followSignals (const DeviceValue& device, const FollowRequest& request, const PlacePairs& sensors,
                        double sampleRate, const py::object& voltages, const py::object& signals, py::object progress)
{
    const auto recording = recordingOf (sampleRate, matrixOf (voltages, "voltages_V"), matrixOf (signals, "signals"));
    return followBy (
        device, request, sensors,
        [&] (const ModalModel& model, Eigen::Index count) { return fitting (recording, model, count); },
        std::move (progress));
}

/** One number of each moment. */
template <typename Number>
auto byMoment (const Number& number)
{
    return [number] (const FollowedDevice& value)
    {
        const auto& moments = value.trace.moments;
        Eigen::VectorXd numbers (static_cast<Eigen::Index> (moments.size()));
        std::transform (moments.begin(), moments.end(), numbers.begin(), number);
        return arrayOf (std::move (numbers));
    };
}

/** N x N_m: a number of each moment and of each of the device's own modes. */
auto byMode (Eigen::VectorXd DriftMoment::*numbers)
{
    return [numbers] (const FollowedDevice& value)
    {
        const auto& moments = value.trace.moments;
        Eigen::MatrixXd table (static_cast<Eigen::Index> (moments.size()), value.known);

        for (std::size_t i = 0; i < moments.size(); ++i)
            table.row (static_cast<Eigen::Index> (i)) = inPpm * (moments[i].*numbers).head (value.known).transpose();

        return arrayOf (std::move (table));
    };
}

std::vector<std::string> wordsBy (const FollowedDevice& value,
                                  const std::function<std::string (const DriftMoment&)>& word)
{
    std::vector<std::string> words;
    std::transform (value.trace.moments.begin(), value.trace.moments.end(), std::back_inserter (words), word);
    return words;
}

void bindRequest (py::module_& module)
{
    py::class_<FollowRequest> request (module, "FollowRequest");
    request.def (py::init());
    request.def_readwrite ("idle_ceramic", &FollowRequest::idleCeramic);
    request.def_readwrite ("latency_ms", &FollowRequest::latency);
    request.def_readwrite ("snr_dB", &FollowRequest::signalToNoise);
    request.def_readwrite ("window_s", &FollowRequest::window);
    request.def_readwrite ("memory_s", &FollowRequest::memory);
    request.def_readwrite ("jump_percent", &FollowRequest::largestJump);
    request.def_readwrite ("drift_percent", &FollowRequest::drift);
    request.def_readwrite ("scatter_percent", &FollowRequest::scatter);
    request.def_readwrite ("damping_percent", &FollowRequest::damping);
    request.def_readwrite ("gain_percent", &FollowRequest::gain);
    request.def_readwrite ("feedthrough", &FollowRequest::feedthrough);
    request.def_readwrite ("cache", &FollowRequest::usesCache);
}

void bindMoments (py::class_<FollowedDevice, Followed>& bound)
{
    bound.def_property_readonly ("times_s", byMoment ([] (const DriftMoment& moment) { return moment.time; }));
    bound.def_property_readonly ("common_ppm",
                                 byMoment ([] (const DriftMoment& moment) { return inPpm * moment.common; }));
    bound.def_property_readonly ("unexplained_percent",
                                 byMoment ([] (const DriftMoment& moment) { return inPercent * moment.unexplained; }));
    bound.def_property_readonly ("jumps_percent",
                                 byMoment ([] (const DriftMoment& moment) { return inPercent * moment.jump; }));
    bound.def_property_readonly ("frequency_changes_ppm", byMode (&DriftMoment::frequencies));
    bound.def_property_readonly ("frequency_deviations_ppm", byMode (&DriftMoment::deviations));
    bound.def_property_readonly (
        "states", [] (const FollowedDevice& value)
        { return wordsBy (value, [] (const DriftMoment& moment) { return driftStateWord (moment.state); }); });
    bound.def_property_readonly ("reasons", [] (const FollowedDevice& value)
                                 { return wordsBy (value, [] (const DriftMoment& moment) { return moment.reason; }); });
}
} // namespace

void bindFollow (py::module_& module)
{
    bindRequest (module);
    py::class_<SensorOptions> (module, "SensorScale")
        .def (py::init (
                  [] (double sensitivity, double fullScale) {
                      return SensorOptions { sensitivity, fullScale };
                  }),
              py::arg ("sensitivity_mm_s_per_V"), py::arg ("input_full_scale_V"));

    py::class_<FollowedDevice, Followed> bound (module, "Followed");
    bound.def_static ("of_folder", &followFolder);
    bound.def_static ("of_signals", &followSignals);
    bound.def_property_readonly ("numbers",
                                 [] (const FollowedDevice& value) { return driftToJson (value.trace).dump(); });
    bound.def_property_readonly ("device", [] (const FollowedDevice& value) { return driftedDeviceText (value); });
    bound.def ("save", [] (const FollowedDevice& value, const std::string& folder)
               { workAway ([&] { writeDrift (folder, value); }); });
    bindFigures (bound, [] (const FollowedDevice& value) { return driftReport (value); });
    bindMoments (bound);
}
} // namespace antinode
