#include "Bindings.h"
#include "Keywords.h"
#include "ResultClass.h"

#include <antinode_base/Prefixes.h>
#include <antinode_reports/MapReport.h>
#include <antinode_tasks/FieldNames.h>
#include <antinode_tasks/Map.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace antinode
{
namespace
{
namespace py = pybind11;
using Value = MappedDevice;

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
        return Eigen::MatrixXd (values.reshaped (map.columns, map.rows).transpose());
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

/** Sentences by row and column. */
py::dict errorsOf (const Value& mapped)
{
    py::dict errors;
    Eigen::Index index = 0;

    for (const auto& place : mapped.map.places)
    {
        if (! place.error.empty())
            errors[py::make_tuple (index / mapped.map.columns, index % mapped.map.columns)] =
                withKeysAndOptions (place.error);

        ++index;
    }

    return errors;
}
} // namespace

void bindMap (py::module_& module)
{
    constexpr const char* about =
        "A focus at every place of a surface: N_y rows from below, N_x columns. Made by :func:`antinode.map`.\n\n"
        "Arrays are N_y x N_x, with NaN where there is no design; on a line N_y is 1.";
    constexpr int howSharp = 1; // figure
    ResultClass<Value> (module, "Mapped", about)
        .isShownAs (
            [] (const Value& value)
            {
                return "Mapped '" + value.map.focus + "' on '" + value.map.device + "': "
                       + std::to_string (value.map.columns) + " x " + std::to_string (value.map.rows) + " places";
            })
        .has ("device", "The name of the device.", [] (const Value& value) { return value.map.device; })
        .has ("focus", "The name of the focus.", [] (const Value& value) { return value.map.focus; })
        .has ("x_mm", "N_x: where the columns are, mm.",
              [] (const Value& value) { return standsAt (value.map, value.map.columns, 1, &MapPlace::x); })
        .has ("y_mm", "N_y: where the rows are, mm.",
              [] (const Value& value) { return standsAt (value.map, value.map.rows, value.map.columns, &MapPlace::y); })
        .has ("captured",
              "The root of the share of the wanted field's energy that the controlled modes represent; 1 is best.",
              numbersBy ([] (const MapPlace& place) { return place.captured; }))
        .has ("v_score", "Correlation of the field at the focus with the wanted one; 1 is best.",
              numbersBy ([] (const MapPlace& place) { return place.vScore; }))
        .has ("field_error", "RMS of the field minus the wanted one, over that of the wanted one.",
              numbersBy ([] (const MapPlace& place) { return place.fieldError; }))
        .has ("peak_voltage_V", "The largest voltage that a focus needs there, V.",
              numbersBy ([] (const MapPlace& place) { return place.peakVoltage; }))
        .has ("voltage_limit_V", "The largest voltage that is allowed, V.",
              [] (const Value& value) { return value.map.voltageLimit; })
        .has ("spill_over", "The part of the field that lies in modes beyond the device's own.",
              numbersBy ([] (const MapPlace& place) { return place.spillOver; }))
        .has ("felt_contrast_dB",
              "Sensation level at the focus over that of the strongest place farther away, dB; NaN where it was left "
              "out.",
              numbersBy ([] (const MapPlace& place) { return place.contrast; }))
        .has ("errors", "Why there is no design: sentences by row and column.", &errorsOf, "dict[tuple[int, int], str]")
        .has ("numbers", "All of ``summary.json``.",
              [] (const Value& value) { return Json { mapToJson (value.map).dump() }; })
        .saves ("folder", "Writes the folder of ``antinode map``: ``map.csv``, ``report.html``, ``summary.json``.",
                [] (const Value& value, const std::filesystem::path& folder) { writeMap (folder, value); })
        .does (
            "plot(self, number: str = 'v_score') -> Any",
            "One of the arrays as a Matplotlib figure.\n\nArgs:\n"
            "    number: 'captured', 'v_score', 'field_error', 'peak_voltage_V', 'spill_over' or 'felt_contrast_dB'.",
            [] (const py::object& self, const std::string& number) { return plotBy ("plot_map") (self, number); },
            py::arg ("number") = "v_score")
        .reports ([] (const Value& value) { return mapReport (value.map, value.model); }, howSharp);
    bindTask<MapRequest> (module, "map", mapText, "Mapped", &map);
}
} // namespace antinode
