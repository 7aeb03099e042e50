#include "ArrayViews.h"
#include "Bindings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/IdentifyFiles.h>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** Identified modes, with what was asked for. */
struct IdentifiedValue
{
    IdentifyOptions options;
    IdentificationResult result;
};

using Identified = std::shared_ptr<IdentifiedValue>;

/** @param against  a computed device; None: there is none */
Identified identifyBy (const IdentifyOptions& options, const std::shared_ptr<DeviceValue>& against, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    const auto computed = against ? std::optional (against->description) : std::nullopt;
    return work.run (
        [&] {
            return std::make_shared<IdentifiedValue> (
                IdentifiedValue { options, identifyFiles (options, computed, show) });
        });
}

/** Writes files; empty names: none. */
void saveIdentified (const IdentifiedValue& value, const std::string& device, const std::string& report,
                     const std::string& universalFile, const std::string& transferred)
{
    auto options = value.options;
    options.deviceFile = device;
    options.reportFile = report;
    options.universalFile = universalFile;
    options.transferFile = transferred;
    workAway ([&] { writeIdentified (value.result, options, ! report.empty()); });
}

Eigen::VectorXd hertz (const Eigen::VectorXd& angularFrequencies)
{
    return angularFrequencies / (2 * M_PI);
}

void bindOptions (py::module_& module)
{
    py::class_<IdentifyOptions> options (module, "IdentifyOptions");
    options.def (py::init());
    options.def_readwrite ("files", &IdentifyOptions::files);
    options.def_readwrite ("name", &IdentifyOptions::name);
    options.def_readwrite ("bands", &IdentifyOptions::bands);
    options.def_readwrite ("orders", &IdentifyOptions::orders);
    options.def_readwrite ("is_complex", &IdentifyOptions::isComplex);
    options.def_readwrite ("is_real", &IdentifyOptions::isReal);
    options.def_readwrite ("uses_peaks", &IdentifyOptions::usesPeaks);
    options.def_readwrite ("cache", &IdentifyOptions::usesCache);
    options.def_readwrite ("selected_Hz", &IdentifyOptions::selected);
    options.def_readwrite ("rejected_Hz", &IdentifyOptions::rejected);
    options.def_readwrite ("delay_us", &IdentifyOptions::delay);
    options.def_readwrite ("quantity", &IdentifyOptions::quantity);
    options.def_readwrite ("response_unit", &IdentifyOptions::responseUnit);
    options.def_readwrite ("drive", &IdentifyOptions::drive);
    options.def_readwrite ("drive_unit", &IdentifyOptions::driveUnit);
    options.def_readwrite ("points", &IdentifyOptions::pointsFile);
    options.def_readwrite ("references", &IdentifyOptions::references);
    options.def_readwrite ("variables", &IdentifyOptions::variables);
    options.def_readwrite ("mass_kg", &IdentifyOptions::mass);
    options.def_readwrite ("voltage_limit_V", &IdentifyOptions::voltageLimit);
    options.def_readwrite ("full_scale_V", &IdentifyOptions::fullScaleVoltage);
}
} // namespace

void bindIdentify (py::module_& module)
{
    bindOptions (module);
    py::class_<IdentifiedValue, Identified> bound (module, "Identified");
    bound.def_static ("make", &identifyBy);
    bound.def_property_readonly ("device",
                                 [] (const IdentifiedValue& value) { return identifiedDeviceText (value.result); });
    bound.def_property_readonly ("has_comparison",
                                 [] (const IdentifiedValue& value) { return value.result.comparison.has_value(); });
    bound.def_property_readonly ("warnings",
                                 [] (const IdentifiedValue& value) { return collectWarnings (value.result); });
    bound.def_property_readonly ("reconstruction_error_dB",
                                 [] (const IdentifiedValue& value) { return value.result.modes.reconstructionError; });
    bound.def_property_readonly ("delay_s", [] (const IdentifiedValue& value) { return value.result.modes.delay; });
    bound.def_property_readonly ("frequencies_Hz", [] (const IdentifiedValue& value)
                                 { return arrayOf (hertz (value.result.modes.angularFrequencies)); });
    bound.def_property_readonly ("frequency_deviations_Hz", [] (const IdentifiedValue& value)
                                 { return arrayOf (hertz (value.result.modes.deviations.angularFrequencies)); });
    bound.def_property_readonly ("damping_ratios",
                                 viewProperty<IdentifiedValue> ([] (const IdentifiedValue& value)
                                                                { return &value.result.modes.dampingRatios; }));
    bound.def_property_readonly (
        "damping_deviations", viewProperty<IdentifiedValue> ([] (const IdentifiedValue& value)
                                                             { return &value.result.modes.deviations.dampingRatios; }));
    bound.def ("save", &saveIdentified);
}
} // namespace antinode
