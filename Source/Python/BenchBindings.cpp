#include "Keywords.h"
#include "Module.h"
#include "ResultClass.h"

#include <antinode_base/InputError.h>
#include <antinode_tasks/Excite.h>
#include <antinode_tasks/Frf.h>
#include <antinode_tasks/Identify.h>
#include <antinode_tasks/Import.h>
#include <antinode_tasks/Measure.h>
#include <antinode_tasks/Place.h>
#include <antinode_tasks/Retune.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
namespace py = pybind11;
using Path = std::filesystem::path;

/** One of several parts of a result. @param what  how errors name it */
template <typename Matrix>
const Matrix& partOf (const std::vector<Matrix>& all, int index, const char* what)
{
    if (index < 0 || static_cast<std::size_t> (index) >= all.size())
        throw InputError (what, "is " + std::to_string (index) + "; allowed: 0 to " + std::to_string (all.size() - 1));

    return all[static_cast<std::size_t> (index)];
}

std::vector<std::string> referenceNames (const RecordedResponses& value)
{
    std::vector<std::string> names;

    for (const auto& reference : value.responses.references)
        names.push_back (reference.name);

    return names;
}

/** How many hits of a hammer were used, or left out. */
int hitsOf (const RecordedResponses& value, bool areUsed)
{
    int count = 0;

    if (value.hammer)
        for (const auto& hits : value.hammer->test.hits)
            for (const auto& hit : hits)
                count += hit.fault.empty() == areUsed ? 1 : 0;

    return count;
}

Eigen::VectorXd hertz (const Eigen::VectorXd& angularFrequencies)
{
    return angularFrequencies / (2 * M_PI);
}

void bindExcitation (py::module_& module)
{
    using Value = ExcitationSheet;
    ResultClass<Value> (
        module, "Excitation",
        "The signals that all ceramics play in turn to measure a device: N_b ceramics, N_f lines. Made by "
        ":func:`antinode.excite`.")
        .isShownAs (
            [] (const Value& value)
            {
                return "Excitation of '" + value.device + "': " + std::to_string (value.ceramics.size()) + " ceramics, "
                       + std::to_string (measuredFrequencies (value.excitation).size()) + " lines";
            })
        .has ("device", "The name of the device.", [] (const Value& value) { return value.device; })
        .has ("ceramics", "N_b names, in the order in which they play.",
              [] (const Value& value) { return value.ceramics; })
        .has ("sample_rate_Hz", "Hz.", [] (const Value& value) { return value.excitation.settings.sampleRate; })
        .has ("frequencies_Hz", "N_f: the lines that are measured, Hz.",
              [] (const Value& value) { return measuredFrequencies (value.excitation); })
        .has ("levels_V", "N_b: the peak voltage of each ceramic, V. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.excitation.settings.levels; })
        .has ("full_scale_V", "The voltage of a played sample of 1, V.",
              [] (const Value& value) { return value.fullScaleVoltage; })
        .has ("signal", "The samples of one ceramic's run without the silence after it, peak 1. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.excitation.signal; })
        .has ("crest_factor", "Peak over effective value of the signal.",
              [] (const Value& value) { return value.excitation.crestFactor; })
        .has ("played",
              "(N_b + 1) x samples of full scale: all runs, ceramics first, then the sync channel: "
              "``excitation.wav``.\n\n"
              "Raises:\n    InputError: it has more than 512 MiB.",
              [] (const Value& value) { return Work (py::none()).run ([&] { return playedRuns (value); }); })
        .has ("numbers", "All of ``excitation.json``.",
              [] (const Value& value) { return Json { excitationToJson (value, "signal.wav").dump() }; })
        .saves ("folder",
                "Writes the folder of ``antinode excite``: ``excitation.wav``, ``excitation.json``, ``signal.wav``.",
                [] (const Value& value, const Path& folder) { writeExcitation (folder, value); });
    bindTask<ExcitationRequest> (module, "excite", exciteText, "Excitation", &excite);
}

void bindEstimated (py::module_& module)
{
    using Value = RecordedResponses;
    ResultClass<Value> (
        module, "Estimated",
        "Velocities per volt, or per newton of a hammer: N_f lines, N_p points, N_r references. Made by "
        ":func:`antinode.frf`.")
        .isShownAs (
            [] (const Value& value)
            {
                const auto& responses = value.responses;
                return "Estimated: " + std::to_string (responses.frequencies.size()) + " lines, "
                       + std::to_string (responses.points.rows()) + " points, "
                       + std::to_string (responses.references.size()) + " references";
            })
        .has ("frequencies_Hz", "N_f lines, Hz. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.responses.frequencies; })
        .has ("points_m", "N_p x 2: x and y, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixX2d& { return value.responses.points; })
        .has ("references", "N_r names: ceramics, or the points that the hammer hit.", &referenceNames)
        .does (
            "responses(self, reference: int) -> Complexes",
            "N_f x N_p of a reference (from 0): (m/s)/V, or (m/s)/N of a hammer, complex; NaN where it was not "
            "measured.",
            [] (const Value& value, int reference)
            { return copyOf (partOf (value.responses.values, reference, "reference")); },
            py::arg ("reference"))
        .does (
            "coherence(self, reference: int) -> Floats",
            "N_f x N_p of a reference (from 0): 0 to 1; NaN where it is not known. A view.",
            [] (const py::object& self, int reference)
            { return viewOf (partOf (self.cast<const Value&>().coherence, reference, "reference"), self); },
            py::arg ("reference"))
        .has ("warnings", "Sentences about the quality of the recordings and the assumptions.",
              [] (const Value& value) { return value.warnings; })
        .has ("hits", "How many hits of the hammer were used; 0 of an excitation.",
              [] (const Value& value) { return hitsOf (value, true); })
        .has ("hits_left_out", "How many were not, because they are clipped, double or cut off.",
              [] (const Value& value) { return hitsOf (value, false); })
        .does (
            "save(self, file: Folder, *, report: Optional[Folder] = None) -> None",
            "Writes the universal file of ``antinode frf``, the same bytes.\n\nArgs:\n"
            "    file: for :func:`antinode.identify` and :func:`antinode.retune`.\n"
            "    report: a folder for ``report.html``.\n\nRaises:\n    InputError: a file cannot be written.",
            [] (const Value& value, const Path& file, const std::optional<Path>& report)
            {
                workAway (
                    [&]
                    {
                        if (report)
                        {
                            OutputFolder folder (*report);
                            folder.write ("report.html", renderReport (frfReport (value)));
                            folder.commit();
                        }

                        writeWholeFile (file, universalFile (value));
                    });
            },
            py::arg ("file"), py::kw_only(), py::arg ("report") = py::none())
        .does (
            "plot(self, reference: int = 0) -> Any",
            "The RMS over the points of the responses of a reference (from 0) as a Matplotlib figure.",
            [] (const py::object& self, int reference) { return plotBy ("plot_responses") (self, reference); },
            py::arg ("reference") = 0)
        .reports (&frfReport);
    bindTask<FrfRequest> (module, "frf", frfText, "Estimated", &frf);
}

void bindRetuned (py::module_& module)
{
    using Value = RetunedDevice;
    ResultClass<Value> (module, "Retuned",
                        "A device after a drift: N_m modes, N_b ceramics. Made by :func:`antinode.retune`.")
        .isShownAs (
            [] (const Value& value)
            {
                const auto& found = value.now.found;
                return "Retuned: " + std::to_string (std::count (found.begin(), found.end(), true)) + " of "
                       + std::to_string (found.size()) + " modes found";
            })
        .has ("device", "The updated device; a drawn one stays one.",
              [] (const Value& value) { return DeviceText { retunedDeviceText (value) }; })
        .has ("frequency_changes", "N_m: relative changes of the frequencies. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.now.frequencyChanges; })
        .has ("damping_changes", "N_m: relative changes of the damping ratios. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.now.dampingChanges; })
        .has ("frequency_deviations", "N_m: remaining standard deviations, relative. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.now.frequencyDeviations; })
        .has ("participation_scales", "N_b: factor of each ceramic's participation; 1 where it was not seen. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.now.participationScales; })
        .has (
            "found", "N_m: whether the mode was seen; others moved with their neighbours.",
            [] (const Value& value) { return value.now.found; }, "list[bool]")
        .has ("delay_s", "The delay that all responses share, s.", [] (const Value& value) { return value.now.delay; })
        .has ("reconstruction_error_dB", "Measured minus synthesised over measured velocities, dB.",
              [] (const Value& value) { return value.now.reconstructionError; })
        .has ("warnings", "Assumptions on the responses, as sentences.",
              [] (const Value& value) { return value.remarks; })
        .saves ("file", "Writes the device file of ``antinode retune``, the same bytes.",
                [] (const Value& value, const Path& file) { writeWholeFile (file, retunedDeviceText (value)); });
    bindTask<RetuneRequest> (module, "retune", retuneText, "Retuned", &retune);
}

void bindMeasured (py::module_& module)
{
    using Value = MeasuredSurface;
    ResultClass<Value> (module, "Measured",
                        "Velocities per volt at points: N_f lines, N_p points, N_b ceramics. Made by "
                        ":func:`antinode.measure`.")
        .isShownAs (
            [] (const Value& value)
            {
                const auto& responses = value.measurement.responses;
                return "Measured: " + std::to_string (responses.points.rows()) + " points, "
                       + std::to_string (responses.frequencies.size()) + " lines";
            })
        .has ("frequencies_Hz", "N_f lines, Hz. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.measurement.responses.frequencies; })
        .has ("points_m", "N_p x 2: x and y, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixX2d& { return value.measurement.responses.points; })
        .has ("warnings", "Sentences about the quality of the measurement; empty where all is well.",
              [] (const Value& value) { return collectWarnings (value.measurement); })
        .does (
            "responses(self, ceramic: int) -> Complexes",
            "N_f x N_p: velocity per volt of a ceramic (from 0), (m/s)/V, complex; NaN where it was not measured.",
            [] (const Value& value, int ceramic)
            { return copyOf (partOf (value.measurement.responses.values, ceramic, "ceramic")); },
            py::arg ("ceramic"));
    bindTask<MeasureRequest> (module, "measure", measureText, "Measured", &measure);
}

void bindIdentified (py::module_& module)
{
    using Value = IdentificationResult;
    ResultClass<Value> (module, "Identified",
                        "Modes that follow from measured responses: N_m modes. Made by :func:`antinode.identify`.")
        .isShownAs (
            [] (const Value& value) {
                return "Identified: " + std::to_string (value.modes.modes()) + " modes, error "
                       + reconstructionError (value);
            })
        .has ("device", "The device with these modes, of kind 'modal'.",
              [] (const Value& value) { return DeviceText { identifiedDeviceText (value) }; })
        .has ("frequencies_Hz", "N_m, Hz.", [] (const Value& value) { return hertz (value.modes.angularFrequencies); })
        .has ("frequency_deviations_Hz", "N_m: their standard deviations, Hz.",
              [] (const Value& value) { return hertz (value.modes.deviations.angularFrequencies); })
        .has ("damping_ratios", "N_m. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.modes.dampingRatios; })
        .has ("damping_deviations", "N_m: their standard deviations. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.modes.deviations.dampingRatios; })
        .has ("delay_s", "The delay that all responses share, s.",
              [] (const Value& value) { return value.modes.delay; })
        .has ("reconstruction_error_dB", "Measured minus synthesised over measured velocities, dB.",
              [] (const Value& value) { return value.modes.reconstructionError; })
        .has ("warnings", "Sentences about files, identification and modes.",
              [] (const Value& value) { return collectWarnings (value); })
        .does (
            "save(self, device: Folder, *, report: Optional[Folder] = None, universal_file: Optional[Folder] = None, "
            "transferred: Optional[Folder] = None) -> None",
            "Writes the files of ``antinode identify``, the same bytes.\n\nArgs:\n"
            "    device: the device file (``--out``).\n"
            "    report: an HTML file, and beside it the diagram to pick modes (``--report``).\n"
            "    universal_file: frequencies and shapes (``--uff``).\n"
            "    transferred: the computed device with the measured frequencies; needs ``against`` (``--transfer``).",
            [] (const Value& value, const Path& device, const std::optional<Path>& report,
                const std::optional<Path>& universal, const std::optional<Path>& transferred)
            {
                const IdentifiedFiles files { device, report.value_or (""), universal.value_or (""),
                                              transferred.value_or ("") };
                workAway ([&] { writeIdentified (value, files); });
            },
            py::arg ("device"), py::kw_only(), py::arg ("report") = py::none(), py::arg ("universal_file") = py::none(),
            py::arg ("transferred") = py::none());
    bindTask<IdentifyRequest, IdentificationResult> (module, "identify", identifyText, "Identified", &identify);
}

void bindPlaced (py::module_& module)
{
    using Value = PlacedDevice;
    ResultClass<Value> (module, "Placed", "Positions of ceramics. Made by :func:`antinode.place`.")
        .isShownAs ([] (const Value& value)
                    { return "Placed: the best of " + std::to_string (value.placed.candidates) + " positions"; })
        .has ("device", "The device with its ceramics at the positions found.",
              [] (const Value& value) { return DeviceText { value.document }; })
        .has ("controllability", "How well the worst combination of modes is moved, relative to average positions.",
              [] (const Value& value) { return value.placed.controllability; })
        .has ("controllability_with_ceramics",
              "The same with the ceramics' mass and stiffness; None where the device was not solved again.",
              [] (const Value& value) { return value.placed.resolved; })
        .has ("candidates", "The number of positions among which was chosen.",
              [] (const Value& value) { return value.placed.candidates; });
    bindTask<PlaceRequest> (module, "place", placeText, "Placed", &place);
}

void bindImported (py::module_& module)
{
    using Value = ImportedDevice;
    ResultClass<Value> (module, "Imported",
                        "A device from results of a finite-element program: N_b ceramics. Made by "
                        ":func:`antinode.import_device`.")
        .isShownAs (
            [] (const Value& value) {
                return "Imported '" + value.model.name + "': " + std::to_string (value.nodesOfSurface)
                       + " nodes of its surface";
            })
        .has ("device", "The device, of kind 'modal'.",
              [] (const Value& value) { return DeviceText { importedDeviceText (value) }; })
        .has ("mass_kg", "The mass that the surface represents, from the norms of the shapes, kg.",
              [] (const Value& value) { return value.mass; })
        .has ("total_mass_kg", "The mass in the table of the program, kg; None: it has none.",
              [] (const Value& value) { return value.totalMass; })
        .has ("static_errors",
              "N_b: residual of the static displacement by each ceramic, RMS, relative; empty: unknown.",
              [] (const Value& value) { return value.staticErrors; })
        .has ("modes_left_out", "How many modes do not move the surface along its normal.",
              [] (const Value& value) { return value.leftOut; })
        .has ("surface_nodes", "How many nodes the surface has, before they were thinned.",
              [] (const Value& value) { return value.nodesOfSurface; })
        .has ("warnings", "Warnings about the device, as sentences.",
              [] (const Value& value) { return value.warnings; })
        .saves ("file", "Writes the device file of ``antinode import``, the same bytes.",
                [] (const Value& value, const Path& file) { writeWholeFile (file, importedDeviceText (value)); });
    bindTask<ImportRequest> (module, "import_device", importText, "Imported", &importDevice);
}
} // namespace

void bindBench (py::module_& module)
{
    bindExcitation (module);
    bindEstimated (module);
    bindRetuned (module);
    bindMeasured (module);
    bindIdentified (module);
    bindPlaced (module);
    bindImported (module);
}
} // namespace antinode
