#include "Bindings.h"
#include "ResultClass.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/SweepCases.h>
#include <antinode_sweep/SweepFolder.h>
#include <antinode_tasks/FieldNames.h>
#include <antinode_tasks/SweptFiles.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

namespace antinode
{
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
