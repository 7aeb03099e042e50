#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <CommandLine/EstimatedFiles.h>
#include <CommandLine/HammerRecordings.h>
#include <antinode_base/InputError.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_universal/UniversalFile.h>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** Frequency responses of recordings: of an excitation, or of a hammer. */
struct EstimatedValue
{
    FrequencyResponses responses;
    std::vector<Eigen::MatrixXd> coherence; ///< N_b of N_f x N_p
    std::string universalFile;
    std::vector<std::string> warnings;
    ReportPage report;
    int hits = 0, hitsLeftOut = 0; ///< Of a hammer.
};

using Estimated = std::shared_ptr<EstimatedValue>;

Estimated ofExcitation (const Excited& sheet, RecordingOptions options, const std::string& estimator)
{
    options.estimator = estimatorNamed (estimator);
    return Work (py::none())
        .run (
            [&]
            {
                const auto measured = estimateResponses (*sheet, options);
                return std::make_shared<EstimatedValue> (
                    EstimatedValue { measured.responses, measured.coherence, measurementText (measured),
                                     collectWarnings (measured), measurementReport (measured, *sheet), 0, 0 });
            });
}

Estimated ofHammer (const std::vector<std::string>& files, const std::string& points, const std::string& estimator,
                    const HammerRecordingOptions& options)
{
    return Work (py::none())
        .run (
            [&]
            {
                const auto measured = measureHammerFiles (files, points, estimatorNamed (estimator), options);
                auto value = std::make_shared<EstimatedValue> (EstimatedValue {
                    measured.responses, measured.coherence, encodeUniversalFile (hammerSets (measured)),
                    measured.remarks, hammerReport (measured), 0, 0 });

                for (const auto& hits : measured.test.hits)
                    for (const auto& hit : hits)
                        ++(hit.fault.empty() ? value->hits : value->hitsLeftOut);

                return value;
            });
}

/** One reference's part of all. */
template <typename Matrix>
const Matrix& ofReference (const std::vector<Matrix>& all, std::size_t reference)
{
    if (reference >= all.size())
        throw InputError ("reference",
                          "is " + std::to_string (reference) + "; allowed: 0 to " + std::to_string (all.size() - 1));

    return all[reference];
}

std::vector<std::string> referenceNames (const EstimatedValue& value)
{
    std::vector<std::string> names;

    for (const auto& reference : value.responses.references)
        names.push_back (reference.name);

    return names;
}

/** @param report  a folder; empty: no report is written */
void save (const EstimatedValue& value, const std::string& file, const std::string& report)
{
    workAway (
        [&]
        {
            if (! report.empty())
            {
                OutputFolder folder (report);
                folder.write ("report.html", renderReport (value.report));
                folder.commit();
            }

            writeWholeFile (file, value.universalFile);
        });
}

void bindRecordingOptions (py::module_& module)
{
    py::class_<RecordingOptions> options (module, "RecordingOptions");
    options.def (py::init());
    options.def_readwrite ("files", &RecordingOptions::files);
    options.def_readwrite ("points", &RecordingOptions::pointsFile);
    options.def_readwrite ("sensor", &RecordingOptions::sensor);
    options.def_readwrite ("sync_channel", &RecordingOptions::syncChannel);
    options.def_readwrite ("reference_channel", &RecordingOptions::referenceChannel);
    options.def_readwrite ("reference_full_scale_V", &RecordingOptions::referenceFullScale);
    options.def_readwrite ("latency_ms", &RecordingOptions::latency);
}

void bindHammerOptions (py::module_& module)
{
    py::class_<HammerRecordingOptions> options (module, "HammerOptions");
    options.def (py::init());
    options.def_readwrite ("channels", &HammerRecordingOptions::channels);
    options.def_readwrite ("hit_point", &HammerRecordingOptions::hitPoint);
    options.def_readwrite ("quantity", &HammerRecordingOptions::quantity);
    options.def_readwrite ("response_unit", &HammerRecordingOptions::responseUnit);
    options.def_readwrite ("response_scale", &HammerRecordingOptions::responseScale);
    options.def_readwrite ("force_unit", &HammerRecordingOptions::forceUnit);
    options.def_readwrite ("force_scale", &HammerRecordingOptions::forceScale);
    options.def_readwrite ("trigger_percent", &HammerRecordingOptions::trigger);
    options.def_readwrite ("block_s", &HammerRecordingOptions::block);
    options.def_readwrite ("window_decay_per_s", &HammerRecordingOptions::windowDecay);
    options.def_readwrite ("lowest_frequency_Hz", &HammerRecordingOptions::lowest);
    options.def_readwrite ("highest_frequency_Hz", &HammerRecordingOptions::highest);
}
} // namespace

void bindFrf (py::module_& module)
{
    bindRecordingOptions (module);
    bindHammerOptions (module);
    py::class_<EstimatedValue, Estimated> bound (module, "Estimated");
    bound.def_static ("of_excitation", &ofExcitation);
    bound.def_static ("of_hammer", &ofHammer);
    bound.def_property_readonly ("references", &referenceNames);
    bound.def_property_readonly (
        "frequencies_Hz",
        viewProperty<EstimatedValue> ([] (const EstimatedValue& value) { return &value.responses.frequencies; }));
    bound.def_property_readonly ("points_m", viewProperty<EstimatedValue> ([] (const EstimatedValue& value)
                                                                           { return &value.responses.points; }));
    bound.def ("responses", [] (const EstimatedValue& value, std::size_t reference)
               { return copyOf (ofReference (value.responses.values, reference)); });
    bound.def ("coherence", [] (const py::object& self, std::size_t reference)
               { return viewOf (ofReference (self.cast<const EstimatedValue&>().coherence, reference), self); });
    bound.def_property_readonly ("warnings", [] (const EstimatedValue& value) { return value.warnings; });
    bound.def_property_readonly ("hits", [] (const EstimatedValue& value) { return value.hits; });
    bound.def_property_readonly ("hits_left_out", [] (const EstimatedValue& value) { return value.hitsLeftOut; });
    bound.def ("save", &save);
    bindFigures (bound, [] (const EstimatedValue& value) { return value.report; });
}
} // namespace antinode
