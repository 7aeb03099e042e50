#include "ArrayViews.h"
#include "Bindings.h"
#include "Places.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/ExcitationOptions.h>
#include <CommandLine/FocusOnDevice.h>
#include <CommandLine/MeasuredFiles.h>
#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_bench/Measuring.h>
#include <antinode_bench/SimulatedBenchPlayer.h>
#include <antinode_library/Library.h>

#include <pybind11/stl.h>

#include <algorithm>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** A measurement with its excitation. */
struct MeasuredValue
{
    SurfaceMeasurement measurement;
};

using Measured = std::shared_ptr<MeasuredValue>;

/** What stands on the simulated bench. */
struct BenchSettings
{
    double signalToNoise = 0;   ///< dB
    double delay = 0;           ///< ms
    double cubicDistortion = 0; ///< %
};

ModalModel excitable (const DeviceValue& device, bool usesCache)
{
    auto model = solveDevice (device.description, {}, usesCache);
    checkExcitable (model);
    return model;
}

SurfaceMeasurement simulate (const ModalModel& model, const ModalModel& onBench, const Eigen::MatrixX2d& points,
                             const std::string& folder, const ExcitationOptions& excitation,
                             const BenchSettings& settings, const ShowProgress& progress)
{
    SimulatedBenchSettings simulation;
    simulation.signalToNoise = settings.signalToNoise;
    simulation.delay = settings.delay / milli;
    simulation.cubic = settings.cubicDistortion / 100;
    const auto sheet = excitationFor (model, excitation);
    SimulatedBenchPlayer bench (onBench, points, simulation);
    const MeasurementFolder measured (folder, sheet, points);
    Eigen::Index told = 0;
    const PointGuide guide (
        [&] (const std::string& sentence)
        {
            if (progress)
                progress (sentence, std::min (1.0, static_cast<double> (told++) / static_cast<double> (points.rows())));
        });
    auto measurement = measurePoints (bench, sheet, points, measured, guide, {});
    writeMeasured (folder, measurement, sheet);
    return measurement;
}

Measured measure (const DeviceValue& device, const PlacePairs& points, const std::string& folder,
                  const ExcitationOptions& excitation, const DeviceValue& onBench, const BenchSettings& settings,
                  py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            const auto places = placesOf (points, "points_mm");
            const auto model = excitable (device, excitation.usesCache);
            checkKindOfPlaces (model, places, "point");
            const auto bench = excitable (onBench, excitation.usesCache);
            return std::make_shared<MeasuredValue> (
                MeasuredValue { simulate (model, bench, places, folder, excitation, settings, show) });
        });
}

/** N_f x N_p of one ceramic, (m/s)/V. */
py::array responsesOf (const MeasuredValue& value, std::size_t ceramic)
{
    const auto& all = value.measurement.responses.values;

    if (ceramic >= all.size())
        throw InputError ("ceramic",
                          "is " + std::to_string (ceramic) + "; allowed: 0 to " + std::to_string (all.size() - 1));

    return copyOf (all[ceramic]);
}
} // namespace

void bindMeasure (py::module_& module)
{
    py::class_<BenchSettings> (module, "BenchSettings")
        .def (py::init<double, double, double>(), py::arg ("snr_dB"), py::arg ("delay_ms"), py::arg ("cubic_percent"));

    py::class_<MeasuredValue, Measured> bound (module, "Measured");
    bound.def_static ("make", &measure);
    bound.def_property_readonly ("frequencies_Hz",
                                 viewProperty<MeasuredValue> ([] (const MeasuredValue& value)
                                                              { return &value.measurement.responses.frequencies; }));
    bound.def_property_readonly (
        "points_m",
        viewProperty<MeasuredValue> ([] (const MeasuredValue& value) { return &value.measurement.responses.points; }));
    bound.def_property_readonly ("ceramics", [] (const MeasuredValue& value)
                                 { return value.measurement.responses.references.size(); });
    bound.def_property_readonly ("warnings",
                                 [] (const MeasuredValue& value) { return collectWarnings (value.measurement); });
    bound.def ("responses", &responsesOf);
}
} // namespace antinode
