#include "ArrayViews.h"
#include "Bindings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/ExcitationOptions.h>
#include <CommandLine/ExcitedFiles.h>
#include <antinode_documents/ExcitationFolder.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

Excited excite (const DeviceValue& device, const ExcitationOptions& options)
{
    return Work (py::none())
        .run (
            [&]
            {
                const auto model = solveDevice (device.description, {}, options.usesCache);
                checkExcitable (model);
                return std::make_shared<ExcitationSheet> (excitationFor (model, options));
            });
}

Excited readExcited (const std::string& file)
{
    return Work (py::none()).run ([&] { return std::make_shared<ExcitationSheet> (readSheet (file)); });
}

void bindOptions (py::module_& module)
{
    py::class_<ExcitationOptions> options (module, "ExcitationOptions");
    options.def (py::init());
    options.def_readwrite ("cache", &ExcitationOptions::usesCache);
    options.def_readwrite ("signal", &ExcitationOptions::signal);
    options.def_readwrite ("sample_rate_Hz", &ExcitationOptions::rate);
    options.def_readwrite ("lowest_frequency_Hz", &ExcitationOptions::lowest);
    options.def_readwrite ("highest_frequency_Hz", &ExcitationOptions::highest);
    options.def_readwrite ("resolution_Hz", &ExcitationOptions::resolution);
    options.def_readwrite ("periods", &ExcitationOptions::periods);
    options.def_readwrite ("settling_periods", &ExcitationOptions::settling);
    options.def_readwrite ("sweep_s", &ExcitationOptions::sweepDuration);
    options.def_readwrite ("odd", &ExcitationOptions::hasOddLines);
    options.def_readwrite ("seed", &ExcitationOptions::seed);
    options.def_readwrite ("levels_V", &ExcitationOptions::levels);
}
} // namespace

void bindExcite (py::module_& module)
{
    bindOptions (module);
    py::class_<ExcitationSheet, Excited> bound (module, "Excitation");
    bound.def_static ("make", &excite);
    bound.def_static ("load", &readExcited);
    bound.def_property_readonly ("device", [] (const ExcitationSheet& value) { return value.device; });
    bound.def_property_readonly ("ceramics", [] (const ExcitationSheet& value) { return value.ceramics; });
    bound.def_property_readonly ("full_scale_V", [] (const ExcitationSheet& value) { return value.fullScaleVoltage; });
    bound.def_property_readonly ("sample_rate_Hz",
                                 [] (const ExcitationSheet& value) { return value.excitation.settings.sampleRate; });
    bound.def_property_readonly ("crest_factor",
                                 [] (const ExcitationSheet& value) { return value.excitation.crestFactor; });
    bound.def_property_readonly ("frequencies_Hz", [] (const ExcitationSheet& value)
                                 { return arrayOf (measuredFrequencies (value.excitation)); });
    bound.def_property_readonly ("levels_V",
                                 viewProperty<ExcitationSheet> ([] (const ExcitationSheet& value)
                                                                { return &value.excitation.settings.levels; }));
    bound.def_property_readonly ("signal", viewProperty<ExcitationSheet> ([] (const ExcitationSheet& value)
                                                                          { return &value.excitation.signal; }));
    bound.def ("played", [] (const ExcitationSheet& value)
               { return arrayOf (Work (py::none()).run ([&] { return playedRuns (value); })); });
    bound.def_property_readonly ("numbers", [] (const ExcitationSheet& value)
                                 { return excitationToJson (value, "signal.wav").dump(); });
    bound.def ("save", [] (const ExcitationSheet& value, const std::string& folder)
               { workAway ([&] { writeExcitation (folder, value); }); });
}
} // namespace antinode
