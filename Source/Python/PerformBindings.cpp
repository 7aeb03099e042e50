#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/PerformedFiles.h>
#include <CommandLine/RecordedPasses.h>
#include <antinode_base/Prefixes.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_library/TrackModels.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** Tracks as they were played. */
struct PerformedValue
{
    PerformedWaveforms performed;
};

using Performed = std::shared_ptr<PerformedValue>;

/** What of `antinode perform` is neither waveforms nor device. */
struct PerformSettings
{
    double sampleRate = 0;     ///< Hz
    double latency = 0;        ///< ms
    double longestLatency = 0; ///< ms, of recordings
    std::string thresholdFile;
    std::vector<std::string> passes;
    SensorOptions sensor;
    bool usesCache = true;
};

PerformedWaveforms performOn (const WaveformsDescription& waveforms, const DeviceDescription& device,
                              const PerformSettings& settings, const ShowProgress& progress)
{
    TrackSettings tracks;
    tracks.sampleRate = settings.sampleRate;
    tracks.latency = settings.latency / milli;
    tracks.threshold = findSkinThreshold (settings.thresholdFile);

    if (progress)
        progress ("Modes of the device", 0);

    const auto [known, judge] = trackModels (device, settings.usesCache);
    const auto passes = withoutLatency (readRecordedPasses (settings.passes, known, waveforms.band, settings.sensor),
                                        known, waveforms, settings.sampleRate, settings.longestLatency / milli);
    return performWaveforms (known, judge, waveforms, tracks, progress, passes);
}

Performed perform (const WaveformsValue& waveforms, const DeviceValue& device, const PerformSettings& settings,
                   py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            return std::make_shared<PerformedValue> (
                PerformedValue { performOn (waveforms.description, device.description, settings, show) });
        });
}

void savePerformed (const PerformedValue& value, const std::string& folder, bool hasReport)
{
    workAway ([&] { writePerformed (folder, value.performed, { hasReport }); });
}

std::vector<std::string> fingerNames (const PerformedValue& value)
{
    std::vector<std::string> names;

    for (std::size_t p = 0; p < value.performed.scores.fingers.size(); ++p)
        names.push_back (fingerName (value.performed.design.description, p));

    return names;
}
} // namespace

void bindPerform (py::module_& module)
{
    py::class_<PerformSettings> (module, "PerformSettings")
        .def (py::init (
                  [] (double rate, double latency, std::string threshold, std::vector<std::string> passes,
                      double longestLatency, double sensitivity, double inputFullScale, bool cache)
                  {
                      return PerformSettings { rate,
                                               latency,
                                               longestLatency,
                                               std::move (threshold),
                                               std::move (passes),
                                               { sensitivity, inputFullScale },
                                               cache };
                  }),
              py::arg ("sample_rate_Hz"), py::arg ("latency_ms"), py::arg ("threshold"), py::arg ("passes"),
              py::arg ("longest_latency_ms"), py::arg ("sensitivity_mm_s_per_V"), py::arg ("input_full_scale_V"),
              py::arg ("cache"));

    py::class_<PerformedValue, Performed> bound (module, "Performed");
    bound.def_static ("make", &perform);
    bound.def_property_readonly ("summary",
                                 [] (const PerformedValue& value) { return performedToJson (value.performed).dump(); });
    bound.def_property_readonly ("sample_rate_Hz",
                                 [] (const PerformedValue& value) { return value.performed.played.sampleRate; });
    bound.def_property_readonly ("trigger_sample",
                                 [] (const PerformedValue& value) { return value.performed.played.trigger; });
    bound.def_property_readonly ("fingers", &fingerNames);
    bound.def_property_readonly ("voltages_V",
                                 viewProperty<PerformedValue> ([] (const PerformedValue& value)
                                                               { return &value.performed.design.voltages.values; }));
    bound.def_property_readonly (
        "output_voltages_V",
        viewProperty<PerformedValue> ([] (const PerformedValue& value) { return &outputVoltages (value.performed); }));
    bound.def_property_readonly ("displacements_m",
                                 viewProperty<PerformedValue> ([] (const PerformedValue& value)
                                                               { return &value.performed.played.displacements; }));
    bound.def_property_readonly ("wanted_m", viewProperty<PerformedValue> ([] (const PerformedValue& value)
                                                                           { return &value.performed.design.wanted; }));
    bound.def ("save", &savePerformed);
}
} // namespace antinode
