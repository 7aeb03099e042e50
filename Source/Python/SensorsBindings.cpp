#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Places.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/SensorsOnDevice.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Chosen = std::shared_ptr<SensorsOnDevice>;

Chosen sensorsFor (const FocusValue& focus, const DeviceValue& device, const SensorRequest& request,
                   py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&] {
            return std::make_shared<SensorsOnDevice> (
                sensorsOnDevice (device.description, focus.description, request, show));
        });
}

Eigen::MatrixX2d chosenPlaces (const SensorsOnDevice& value)
{
    const auto& places = value.places;
    Eigen::MatrixX2d chosen (static_cast<Eigen::Index> (places.choice.chosen.size()), 2);

    for (Eigen::Index i = 0; i < chosen.rows(); ++i)
        chosen.row (i) = sensorPlace (value.model, places, static_cast<std::size_t> (i)).transpose();

    return inMillimetres (chosen);
}
} // namespace

void bindSensors (py::module_& module)
{
    py::class_<SensorRequest> request (module, "SensorRequest");
    request.def (py::init());
    request.def_readwrite ("count", &SensorRequest::count);
    request.def_readwrite ("idle_ceramics", &SensorRequest::idleCeramics);
    request.def_readwrite ("candidates", &SensorRequest::candidates);
    request.def_readwrite ("sample_rate_Hz", &SensorRequest::rate);
    request.def_readwrite ("duration_ms", &SensorRequest::duration);
    request.def_readwrite ("snr_dB", &SensorRequest::signalToNoise);
    request.def_readwrite ("frequency_percent", &SensorRequest::frequency);
    request.def_readwrite ("damping_percent", &SensorRequest::damping);
    request.def_readwrite ("participation_percent", &SensorRequest::participation);
    request.def_readwrite ("cache", &SensorRequest::usesCache);

    py::class_<SensorsOnDevice, Chosen> bound (module, "Sensors");
    bound.def_static ("make", &sensorsFor);
    bound.def_property_readonly ("numbers", [] (const SensorsOnDevice& value)
                                 { return sensorsToJson (value.model, value.places).dump(); });
    bound.def_property_readonly ("places_mm",
                                 [] (const SensorsOnDevice& value) { return arrayOf (chosenPlaces (value)); });
    bound.def_property_readonly ("bits",
                                 [] (const SensorsOnDevice& value)
                                 {
                                     const auto& bits = value.places.choice.bits;
                                     return arrayOf (Eigen::VectorXd (Eigen::Map<const Eigen::VectorXd> (
                                         bits.data(), static_cast<Eigen::Index> (bits.size()))));
                                 });
    bound.def_property_readonly ("random_bits", [] (const SensorsOnDevice& value) { return value.places.randomBits; });
    bound.def_property_readonly ("candidates_mm",
                                 [] (const SensorsOnDevice& value)
                                 {
                                     const auto& places = value.places;
                                     return arrayOf (inMillimetres (places.cells.centres (places.cell, Eigen::all)));
                                 });
    bound.def_property_readonly ("candidate_bits", viewProperty<SensorsOnDevice> ([] (const SensorsOnDevice& value)
                                                                                  { return &value.places.bits; }));
    bound.def ("save", [] (const SensorsOnDevice& value, const std::string& folder)
               { workAway ([&] { writeSensors (folder, value.model, value.places); }); });
    bindFigures (bound, [] (const SensorsOnDevice& value) { return sensorsReport (value.model, value.places); });
}
} // namespace antinode
