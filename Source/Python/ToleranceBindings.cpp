#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/DesignTolerances.h>
#include <antinode_documents/ToleranceFile.h>
#include <antinode_reports/ToleranceReport.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <algorithm>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** What designs do on devices that differ from the model; the last one is the one that was asked about. */
struct ToleranceValue
{
    std::shared_ptr<DesignValue> design;
    ModalModel model;
    std::vector<DesignTolerance> tolerances;

    const std::string& focus() const { return design->made.design.description.name; }
};

using Evaluated = std::shared_ptr<ToleranceValue>;

Evaluated toleranceOf (const std::shared_ptr<DesignValue>& design, const ToleranceCommandOptions& options,
                       py::object progress)
{
    Work work (std::move (progress));
    const auto show = work.progress();
    return work.run (
        [&]
        {
            const auto& wide = design->made.wide;
            auto model = firstModes (wide.model, wide.known);
            auto tolerances = designTolerances (model, design->made.design, options, {}, show);
            return std::make_shared<ToleranceValue> (
                ToleranceValue { design, std::move (model), std::move (tolerances) });
        });
}

/** One of the scores of the design that was asked about, on each device. */
auto scores (double FocusScore::*score)
{
    return [score] (const ToleranceValue& value)
    {
        const auto& draws = value.tolerances.back().tolerance.draws;
        Eigen::VectorXd numbers (static_cast<Eigen::Index> (draws.size()));
        std::transform (draws.begin(), draws.end(), numbers.begin(), [&] (const auto& each) { return each.*score; });
        return arrayOf (std::move (numbers));
    };
}

std::string numbersOf (const ToleranceValue& value)
{
    return toleranceToJson (value.model, value.focus(), value.tolerances).dump();
}

void save (const ToleranceValue& value, const std::string& path)
{
    workAway (
        [&]
        {
            OutputFolder folder (path);
            folder.write ("design.json", designText (*value.design));
            writeTolerances (folder, value.model, value.focus(), value.tolerances);
            folder.commit();
        });
}
} // namespace

void bindTolerance (py::module_& module)
{
    py::class_<ToleranceCommandOptions> options (module, "ToleranceOptions");
    options.def (py::init());
    options.def_readwrite ("draws", &ToleranceCommandOptions::draws);
    options.def_readwrite ("seed", &ToleranceCommandOptions::seed);
    options.def_readwrite ("frequency_percent", &ToleranceCommandOptions::frequency);
    options.def_readwrite ("damping_percent", &ToleranceCommandOptions::damping);
    options.def_readwrite ("participation_percent", &ToleranceCommandOptions::participation);
    options.def_readwrite ("drift_percent", &ToleranceCommandOptions::drift);

    py::class_<ToleranceValue, Evaluated> bound (module, "Tolerance");
    bound.def_static ("make", &toleranceOf);
    bound.def_property_readonly ("numbers", &numbersOf);
    bound.def_property_readonly ("v_scores", scores (&FocusScore::vScore));
    bound.def_property_readonly ("field_errors", scores (&FocusScore::fieldError));
    bound.def_property_readonly ("peak_ratios", scores (&FocusScore::peakRatio));
    bound.def ("text", [] (const ToleranceValue& value) { return tolerancesInWords (value.model, value.tolerances); });
    bound.def ("save", &save);
    bindFigures (bound, [] (const ToleranceValue& value)
                 { return toleranceReport (value.model, value.focus(), value.tolerances); });
}
} // namespace antinode
