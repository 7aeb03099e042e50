#include "Keywords.h"
#include "Module.h"
#include "ResultClass.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/ComparisonReport.h>
#include <antinode_reports/IdentificationTables.h>
#include <antinode_reports/MapReport.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/PartFolder.h>
#include <antinode_sweep/SweepCases.h>
#include <antinode_tasks/Compare.h>
#include <antinode_tasks/Field.h>
#include <antinode_tasks/Map.h>
#include <antinode_tasks/SweptFiles.h>
#include <antinode_text/JsonText.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <optional>

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
py::dict errorsOfPlaces (const Value& mapped)
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
        .has ("errors", "Why there is no design: sentences by row and column.", &errorsOfPlaces,
              "dict[tuple[int, int], str]")
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

namespace
{
py::list casesOf (const ComparedDevices& compared)
{
    using namespace py::literals;
    py::list cases;

    for (const auto& each : compared.cases)
        cases.append (py::dict ("device"_a = each.device, "played"_a = each.played, "ceramics"_a = each.ceramics,
                                "peak_voltage_V"_a = each.peakVoltage, "voltage_limit_V"_a = each.voltageLimit,
                                "peak_current_A"_a = each.peakCurrent, "energy_J"_a = each.energy,
                                "levels_dB_SL"_a = each.levels, "level_share_dB"_a = each.missing,
                                "contrast_dB"_a = each.contrast, "tolerance"_a = each.tolerance,
                                "error"_a = each.error));

    return cases;
}
} // namespace

void bindCompared (py::module_& module)
{
    ResultClass<ComparedDevices> (module, "Compared", "Devices side by side. Made by :func:`antinode.compare`.")
        .isShownAs ([] (const ComparedDevices& value)
                    { return "Compared: " + std::to_string (value.cases.size()) + " cases"; })
        .has ("cases",
              "One of each device and what is played on it, device by device: device, played, ceramics, "
              "peak_voltage_V, voltage_limit_V, peak_current_A, energy_J, levels_dB_SL of the places, level_share_dB "
              "by which the limits lower them, contrast_dB, tolerance of 19 of 20 devices, and error, the sentence of "
              "a case that has no numbers, else empty; NaN: unknown.",
              &casesOf, "list[dict[str, Any]]")
        .saves ("folder",
                "Writes the folder of ``antinode compare``: ``report.html``, ``compare.pdf``, ``scores.csv`` and the "
                "figures that were asked for.",
                [] (const ComparedDevices& value, const std::filesystem::path& folder)
                { writeCompared (folder, value); })
        .reports ([] (const ComparedDevices& value) { return comparisonReport (value.cases); })
        .bound.def ("__str__", [] (const ComparedDevices& value) { return tableText (comparisonTable (value.cases)); });
    bindTask<CompareRequest> (module, "compare", compareText, "Compared", &compare);
}

namespace
{
namespace py = pybind11;

/** A plan whose cases can be computed. */
struct SweepValue
{
    CaseEvaluator evaluator;

    SweepValue (SweepInputs inputs, bool usesCache) : evaluator (std::move (inputs), usesCache) {}
};

using Sweep = std::shared_ptr<SweepValue>;

/** A folder of parts, with the plan that they are of. */
struct SweepPartsValue
{
    Sweep sweep;
    PartFolder folder;
};

using SweepParts = std::shared_ptr<SweepPartsValue>;

/** All cases with what they say. */
struct SweptValue
{
    SweepTable table;
    SweepSummary summary;
};

using Swept = std::shared_ptr<SweptValue>;

EvaluateCase evaluateBy (const SweepValue& sweep)
{
    return [&] (std::uint64_t number) { return sweep.evaluator.evaluate (number); };
}

Sweep loadPlan (const std::string& file, bool usesCache)
{
    return Work (py::none()).run ([&] { return std::make_shared<SweepValue> (loadSweep (file), usesCache); });
}

Sweep parsePlan (const std::string& text, bool usesCache)
{
    return Work (py::none())
        .run ([&] { return std::make_shared<SweepValue> (sweepInputs (parseJson (text, "plan"), "plan"), usesCache); });
}

py::bytes partOf (const SweepValue& sweep, std::size_t index)
{
    const auto bytes = Work (py::none())
                           .run (
                               [&]
                               {
                                   const auto& inputs = sweep.evaluator.inputs();
                                   const auto parts = sweepParts (inputs.plan.cases);

                                   if (index >= parts.size())
                                       throw InputError ("part", "is " + std::to_string (index) + "; allowed: 0 to "
                                                                     + std::to_string (parts.size() - 1));

                                   std::vector<CaseResult> results;
                                   const auto compute = [&] (std::size_t)
                                   { results = computePart (evaluateBy (sweep), parts[index], [] {}); };
                                   parallelFor (1, compute, 1); // one thread in all, as Dask counts
                                   return encodePart (inputs.hash, parts[index].first, results);
                               });
    return { bytes };
}

SweepParts openFolder (const Sweep& sweep, const std::string& folder)
{
    return Work (py::none())
        .run (
            [&]
            {
                return std::make_shared<SweepPartsValue> (
                    SweepPartsValue { sweep, sweepFolder (folder, sweep->evaluator.inputs()) });
            });
}

void computeHere (const SweepPartsValue& value, std::optional<std::size_t> threads, py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    work.run (
        [&]
        {
            const auto missing = value.folder.missing ({});
            const auto all = value.folder.casesOf (missing);
            computeParts (evaluateBy (*value.sweep), value.folder, missing, threads.value_or (processorThreads()),
                          [&] (std::uint64_t done)
                          {
                              if (show)
                                  show ("Sweeping", static_cast<double> (done) / static_cast<double> (all));
                          });
            return true;
        });
}

/** @param bytes  what partOf gave, perhaps on another computer */
void keepPart (const SweepPartsValue& value, std::size_t index, const std::string& bytes)
{
    if (index >= value.folder.parts().size())
        throw InputError ("part", "is " + std::to_string (index) + "; allowed: 0 to "
                                      + std::to_string (value.folder.parts().size() - 1));

    workAway ([&] { value.folder.keep (index, bytes); });
}

Swept merge (const SweepPartsValue& value)
{
    return Work (py::none())
        .run (
            [&]
            {
                auto table = mergeParts (value.folder, value.sweep->evaluator.inputs());
                auto summary = summarise (table);
                return std::make_shared<SweptValue> (SweptValue { std::move (table), std::move (summary) });
            });
}

/** Sentences by the numbers of cases. */
py::dict errorsOf (const SweptValue& value)
{
    py::dict errors;

    for (std::size_t i = 0; i < value.table.errors.size(); ++i)
        if (const auto& error = value.table.errors[i]; ! error.empty())
            errors[py::int_ (i)] = withKeysAndOptions (error);

    return errors;
}

/** N_c numbers of a key that varies or of a recorded number. @throws InputError  where there is neither */
py::array columnOf (const py::object& self, const std::string& name)
{
    const auto& table = self.cast<const SweptValue&>().table;
    const auto keys = sweptKeys (table.inputs.plan);
    const auto recorded = std::find (table.columns.begin(), table.columns.end(), name);

    if (recorded != table.columns.end())
        return viewOf (table.values.col (recorded - table.columns.begin()), self);

    if (const auto key = std::find (keys.begin(), keys.end(), name); key != keys.end())
        return arrayOf (sweptNumbers (table, static_cast<std::size_t> (key - keys.begin())));

    std::vector<std::string_view> allowed (keys.begin(), keys.end());
    allowed.insert (allowed.end(), table.columns.begin(), table.columns.end());
    throw InputError ("column", "is " + inQuotes (name) + "; allowed: " + listed (allowed));
}

void bindSwept (py::module_& module)
{
    using Value = SweptValue;
    ResultClass<Value> (module, "Swept",
                        "All cases of a sweep: N_c cases, N_k keys that vary, N_r recorded numbers. Made by "
                        ":func:`antinode.sweep`.")
        .isShownAs (
            [] (const Value& value)
            {
                return "Swept '" + value.table.inputs.plan.name + "': " + std::to_string (value.table.values.rows())
                       + " cases, " + std::to_string (value.table.values.cols()) + " results";
            })
        .has ("name", "The name of the plan.", [] (const Value& value) { return value.table.inputs.plan.name; })
        .has ("keys", "N_k keys that vary, with their units: ``focus.targets.0.x_mm``.",
              [] (const Value& value) { return sweptKeys (value.table.inputs.plan); })
        .has ("columns", "N_r recorded numbers, with their units, as the head of ``results.csv`` has them.",
              [] (const Value& value) { return value.table.columns; })
        .has (
            "values",
            "N_c x N_r: the recorded numbers, in the units of ``columns``; NaN where a case has none. A view.",
            [](const Value& value) -> const auto& { return value.table.values; })
        .has ("errors", "The sentences of the cases (from 0) that could not be computed.", &errorsOf, "dict[int, str]")
        .has ("summary", "All numbers of ``summary.json``: percentiles, correlations.",
              [] (const Value& value) { return Json { sweepToJson (value.table, value.summary).dump() }; })
        .does (
            "column(self, name: str) -> Floats",
            "N_c numbers of a key that varies or of a recorded number, in the unit of its name. Of a key whose values "
            "are texts, the numbers (from 1) of their rows in the plan.\n\nRaises:\n    InputError: there is no such "
            "key.",
            &columnOf, py::arg ("name"))
        .saves (
            "folder",
            "Writes ``results.csv``, ``results.mat``, ``report.html`` and ``summary.json``, the bytes of ``antinode "
            "sweep``.",
            [] (const Value& value, const std::filesystem::path& folder)
            { writeSwept (folder, value.table, value.summary); })
        .bound.def ("__str__", [] (const Value& value) { return sweepInWords (value.table, value.summary); });
}
} // namespace

void bindSweep (py::module_& module)
{
    py::class_<SweepValue, Sweep> sweep (module, "Sweep");
    sweep.def_static ("load", &loadPlan);
    sweep.def_static ("parse", &parsePlan);
    sweep.def ("check", [] (const SweepValue& value) { workAway ([&] { value.evaluator.check(); }); });
    sweep.def_property_readonly ("document",
                                 [] (const SweepValue& value) { return value.evaluator.inputs().document.dump(); });
    sweep.def ("part", &partOf);

    py::class_<SweepPartsValue, SweepParts> parts (module, "SweepParts");
    sweep.def ("open", &openFolder);
    parts.def_property_readonly ("count", [] (const SweepPartsValue& value) { return value.folder.parts().size(); });
    parts.def ("missing", [] (const SweepPartsValue& value)
               { return Work (py::none()).run ([&] { return value.folder.missing ({}); }); });
    parts.def ("compute", &computeHere);
    parts.def ("keep", &keepPart);
    parts.def ("merge", &merge);
    parts.def ("tidy", [] (const SweepPartsValue& value) { workAway ([&] { value.folder.tidy(); }); });
    bindSwept (module);
}
} // namespace antinode
