#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/FieldNames.h>
#include <CommandLine/MapFiles.h>
#include <antinode_base/Prefixes.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/MapReport.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Mapped = std::shared_ptr<MappedDevice>;

/** What of `antinode map` is neither focus nor device. */
struct MapSettings
{
    int places = 2000;
    double sampleRate = 192000; ///< Hz
    bool hasFelt = true;
    std::string thresholdFile;
    std::optional<std::size_t> threads;
    bool usesCache = true;
};

Mapped mapOf (const FocusValue& focus, const DeviceValue& device, const MapSettings& settings, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            MapOptions options;
            options.places = settings.places;
            options.playback.sampleRate = settings.sampleRate;
            options.threads = settings.threads.value_or (processorThreads());

            if (settings.hasFelt)
                options.threshold = findSkinThreshold (settings.thresholdFile);

            const auto tell = [&] (int done, int all)
            {
                if (show)
                    show ("Mapping", static_cast<double> (done) / all);
            };
            return std::make_shared<MappedDevice> (
                mapOnDevice (device.description, focus.description, options, settings.usesCache, tell));
        });
}

/** A number of all places, rows x columns; not a number where there is none. */
template <typename Number>
auto numbersBy (const Number& number)
{
    return [number] (const MappedDevice& mapped)
    {
        const auto& map = mapped.map;
        Eigen::VectorXd values (static_cast<Eigen::Index> (map.places.size()));
        std::transform (
            map.places.begin(), map.places.end(), values.begin(),
            [&] (const MapPlace& place)
            {
                return place.error.empty()
                           ? std::optional<double> (number (place)).value_or (std::numeric_limits<double>::quiet_NaN())
                           : std::numeric_limits<double>::quiet_NaN();
            });
        return arrayOf (Eigen::MatrixXd (values.reshaped (map.columns, map.rows).transpose()));
    };
}

/** Where columns or rows stand, mm. */
Eigen::VectorXd standsAt (const FocusMap& map, Eigen::Index count, Eigen::Index step, double MapPlace::*coordinate)
{
    Eigen::VectorXd places (count);

    for (Eigen::Index i = 0; i < count; ++i)
        places[i] = milli * (map.places[static_cast<std::size_t> (i * step)].*coordinate);

    return places;
}

std::vector<std::string> errorsOf (const MappedDevice& mapped)
{
    std::vector<std::string> sentences;

    for (const auto& place : mapped.map.places)
        sentences.push_back (withKeysAndOptions (place.error));

    return sentences;
}

void bindArrays (py::class_<MappedDevice, Mapped>& bound)
{
    const auto number = [&] (const char* name, auto value) { bound.def_property_readonly (name, numbersBy (value)); };
    number ("captured", [] (const MapPlace& place) { return place.captured; });
    number ("v_score", [] (const MapPlace& place) { return place.vScore; });
    number ("field_error", [] (const MapPlace& place) { return place.fieldError; });
    number ("peak_voltage_V", [] (const MapPlace& place) { return place.peakVoltage; });
    number ("spill_over", [] (const MapPlace& place) { return place.spillOver; });
    number ("felt_contrast_dB", [] (const MapPlace& place) { return place.contrast; });
    bound.def_property_readonly ("x_mm", [] (const MappedDevice& value)
                                 { return arrayOf (standsAt (value.map, value.map.columns, 1, &MapPlace::x)); });
    bound.def_property_readonly (
        "y_mm", [] (const MappedDevice& value)
        { return arrayOf (standsAt (value.map, value.map.rows, value.map.columns, &MapPlace::y)); });
}
} // namespace

void bindMap (py::module_& module)
{
    py::class_<MapSettings> settings (module, "MapSettings");
    settings.def (py::init());
    settings.def_readwrite ("places", &MapSettings::places);
    settings.def_readwrite ("sample_rate_Hz", &MapSettings::sampleRate);
    settings.def_readwrite ("felt", &MapSettings::hasFelt);
    settings.def_readwrite ("threshold", &MapSettings::thresholdFile);
    settings.def_readwrite ("threads", &MapSettings::threads);
    settings.def_readwrite ("cache", &MapSettings::usesCache);

    py::class_<MappedDevice, Mapped> bound (module, "Mapped");
    bound.def_static ("make", &mapOf);
    bound.def_property_readonly ("device", [] (const MappedDevice& value) { return value.map.device; });
    bound.def_property_readonly ("focus", [] (const MappedDevice& value) { return value.map.focus; });
    bound.def_property_readonly ("voltage_limit_V", [] (const MappedDevice& value) { return value.map.voltageLimit; });
    bound.def_property_readonly ("errors", &errorsOf);
    bound.def_property_readonly ("numbers", [] (const MappedDevice& value) { return mapToJson (value.map).dump(); });
    bound.def ("save", [] (const MappedDevice& value, const std::string& folder)
               { workAway ([&] { writeMap (folder, value); }); });
    bindFigures (bound, [] (const MappedDevice& value) { return mapReport (value.map, value.model); });
    bindArrays (bound);
}
} // namespace antinode
