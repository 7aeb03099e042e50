#include "ArrayViews.h"
#include "Bindings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/RetunedFiles.h>
#include <antinode_text/OutputFolder.h>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Retuned = std::shared_ptr<RetunedDevice>;

Retuned retuneDevice (const DeviceValue& device, const std::vector<std::string>& files,
                      const RetuneDeviations& deviations, bool usesCache)
{
    return Work (py::none())
        .run (
            [&] {
                return std::make_shared<RetunedDevice> (
                    retuneByFiles (device.description, files, deviations, usesCache));
            });
}

void bindChanges (py::class_<RetunedDevice, Retuned>& bound)
{
    bound.def_property_readonly (
        "frequency_changes",
        viewProperty<RetunedDevice> ([] (const RetunedDevice& value) { return &value.now.frequencyChanges; }));
    bound.def_property_readonly (
        "damping_changes",
        viewProperty<RetunedDevice> ([] (const RetunedDevice& value) { return &value.now.dampingChanges; }));
    bound.def_property_readonly (
        "frequency_deviations",
        viewProperty<RetunedDevice> ([] (const RetunedDevice& value) { return &value.now.frequencyDeviations; }));
    bound.def_property_readonly (
        "participation_scales",
        viewProperty<RetunedDevice> ([] (const RetunedDevice& value) { return &value.now.participationScales; }));
    bound.def_property_readonly ("found", [] (const RetunedDevice& value) { return value.now.found; });
    bound.def_property_readonly ("delay_s", [] (const RetunedDevice& value) { return value.now.delay; });
    bound.def_property_readonly ("reconstruction_error_dB",
                                 [] (const RetunedDevice& value) { return value.now.reconstructionError; });
}
} // namespace

void bindRetune (py::module_& module)
{
    py::class_<RetuneDeviations> deviations (module, "RetuneDeviations");
    deviations.def (py::init<>());
    deviations.def_readwrite ("frequency_percent", &RetuneDeviations::frequency);
    deviations.def_readwrite ("drift_percent", &RetuneDeviations::drift);
    deviations.def_readwrite ("damping_percent", &RetuneDeviations::damping);
    deviations.def_readwrite ("participation_percent", &RetuneDeviations::participation);
    deviations.def_readwrite ("place_mm", &RetuneDeviations::place);
    py::class_<RetunedDevice, Retuned> bound (module, "Retuned");
    bound.def_static ("make", &retuneDevice);
    bound.def_property_readonly ("device", [] (const RetunedDevice& value) { return retunedDeviceText (value); });
    bound.def ("save", [] (const RetunedDevice& value, const std::string& file)
               { workAway ([&] { writeWholeFile (file, retunedDeviceText (value)); }); });
    bindChanges (bound);
}
} // namespace antinode
