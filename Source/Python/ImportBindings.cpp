#include "Bindings.h"
#include "Work.h"

#include <CommandLine/ImportFiles.h>
#include <antinode_text/OutputFolder.h>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Imported = std::shared_ptr<ImportedDevice>;

Imported importBy (const ImportOptions& options)
{
    return Work (py::none()).run ([&] { return std::make_shared<ImportedDevice> (importFiles (options)); });
}

/** An option that is a part of the settings. */
template <typename Part>
void bindSetting (py::class_<ImportOptions>& options, const char* name, Part ImportSettings::*part)
{
    options.def_property (
        name, [part] (const ImportOptions& value) { return value.settings.*part; },
        [part] (ImportOptions& value, const Part& given) { value.settings.*part = given; });
}

void bindOptions (py::module_& module)
{
    py::class_<ImportOptions> options (module, "ImportOptions");
    options.def (py::init());
    options.def_readwrite ("files", &ImportOptions::files);
    options.def_readwrite ("normal", &ImportOptions::normal);
    options.def_readwrite ("side", &ImportOptions::side);
    options.def_readwrite ("outline", &ImportOptions::outline);
    options.def_readwrite ("units", &ImportOptions::units);
    options.def_readwrite ("flatness_mm", &ImportOptions::flatness);
    options.def_readwrite ("full_scale_V", &ImportOptions::fullScaleVoltage);
    bindSetting (options, "name", &ImportSettings::name);
    bindSetting (options, "case_voltage_V", &ImportSettings::caseVoltage);
    bindSetting (options, "damping_ratio", &ImportSettings::dampingRatio);
    bindSetting (options, "voltage_limit_V", &ImportSettings::voltageLimit);
    options.def_property (
        "points", [] (const ImportOptions& value) { return value.settings.side.maximumPoints; },
        [] (ImportOptions& value, int points) { value.settings.side.maximumPoints = points; });
}
} // namespace

void bindImport (py::module_& module)
{
    bindOptions (module);
    py::class_<ImportedDevice, Imported> bound (module, "Imported");
    bound.def_static ("make", &importBy);
    bound.def_property_readonly ("device", [] (const ImportedDevice& value) { return importedDeviceText (value); });
    bound.def_property_readonly ("warnings", [] (const ImportedDevice& value) { return value.warnings; });
    bound.def_property_readonly ("mass_kg", [] (const ImportedDevice& value) { return value.mass; });
    bound.def_property_readonly ("total_mass_kg", [] (const ImportedDevice& value) { return value.totalMass; });
    bound.def_property_readonly ("static_errors", [] (const ImportedDevice& value) { return value.staticErrors; });
    bound.def_property_readonly ("modes_left_out", [] (const ImportedDevice& value) { return value.leftOut; });
    bound.def_property_readonly ("surface_nodes", [] (const ImportedDevice& value) { return value.nodesOfSurface; });
    bound.def ("save", [] (const ImportedDevice& value, const std::string& file)
               { workAway ([&] { writeWholeFile (file, importedDeviceText (value)); }); });
}
} // namespace antinode
