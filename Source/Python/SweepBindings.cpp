#include "ArrayViews.h"
#include "Bindings.h"
#include "Work.h"

#include <antinode_base/InputError.h>
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

std::vector<std::string> errorsOf (const SweptValue& value)
{
    std::vector<std::string> sentences (value.table.errors.size());
    std::transform (value.table.errors.begin(), value.table.errors.end(), sentences.begin(), withKeysAndOptions);
    return sentences;
}

void bindSwept (py::module_& module)
{
    py::class_<SweptValue, Swept> swept (module, "Swept");
    swept.def_property_readonly ("name", [] (const SweptValue& value) { return value.table.inputs.plan.name; });
    swept.def_property_readonly ("keys", [] (const SweptValue& value) { return sweptKeys (value.table.inputs.plan); });
    swept.def_property_readonly ("columns", [] (const SweptValue& value) { return value.table.columns; });
    swept.def_property_readonly (
        "values", viewProperty<SweptValue> ([] (const SweptValue& value) { return &value.table.values; }));
    swept.def_property_readonly ("errors", &errorsOf);
    swept.def_property_readonly ("summary", [] (const SweptValue& value)
                                 { return sweepToJson (value.table, value.summary).dump(); });
    swept.def ("numbers",
               [] (const SweptValue& value, std::size_t key) { return arrayOf (sweptNumbers (value.table, key)); });
    swept.def ("text", [] (const SweptValue& value) { return sweepInWords (value.table, value.summary); });
    swept.def ("save", [] (const SweptValue& value, const std::string& folder)
               { workAway ([&] { writeSwept (folder, value.table, value.summary); }); });
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
