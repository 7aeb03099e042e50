#include "ArrayViews.h"
#include "Bindings.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/ExcitationOptions.h>
#include <CommandLine/MeasuredFiles.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
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

Eigen::MatrixX2d placesOf (const std::vector<std::pair<double, double>>& millimetres)
{
    Eigen::MatrixX2d places (static_cast<Eigen::Index> (millimetres.size()), 2);

    for (std::size_t i = 0; i < millimetres.size(); ++i)
        places.row (static_cast<Eigen::Index> (i)) << millimetres[i].first / milli, millimetres[i].second / milli;

    if (places.rows() == 0 || ! places.allFinite())
        throw InputError ("points_mm", "are none or not finite; allowed: at least one place on the surface, mm");

    return places;
}

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

Measured measure (const DeviceValue& device, const std::vector<std::pair<double, double>>& points,
                  const std::string& folder, const ExcitationOptions& excitation, const DeviceValue& onBench,
                  const BenchSettings& settings, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            const auto places = placesOf (points);
            const auto model = excitable (device, excitation.usesCache);
            const auto bench = excitable (onBench, excitation.usesCache);
            return std::make_shared<MeasuredValue> (
                MeasuredValue { simulate (model, bench, places, folder, excitation, settings, show) });
        });
}

/** N_f x N_p of one ceramic, a copy: complex numbers, (m/s)/V. */
py::array_t<std::complex<double>> responsesOf (const MeasuredValue& value, std::size_t ceramic)
{
    const auto& all = value.measurement.responses.values;

    if (ceramic >= all.size())
        throw InputError ("ceramic",
                          "is " + std::to_string (ceramic) + "; allowed: 0 to " + std::to_string (all.size() - 1));

    const auto& values = all[ceramic];
    py::array_t<std::complex<double>, py::array::f_style> array ({ values.rows(), values.cols() });
    std::copy (values.data(), values.data() + values.size(), array.mutable_data());
    return array;
}

void bindExcitation (py::module_& module)
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
    options.def_readwrite ("levels_V", &ExcitationOptions::levels);
}
} // namespace

void bindMeasure (py::module_& module)
{
    bindExcitation (module);
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
