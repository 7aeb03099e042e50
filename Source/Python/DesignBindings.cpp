#include "Keywords.h"
#include "Module.h"
#include "ResultClass.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/ToleranceFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_render/Summary.h>
#include <antinode_reports/FocusCharts.h>
#include <antinode_reports/ToleranceReport.h>
#include <antinode_tasks/Perform.h>
#include <antinode_tasks/Render.h>
#include <antinode_tasks/Tolerance.h>
#include <antinode_tasks/Tradeoffs.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
namespace
{
namespace py = pybind11;
using Path = std::filesystem::path;

py::list oscillations (const DesignedFocus& design)
{
    using namespace py::literals;
    py::list all;

    for (const auto& each : design.made.design.program.oscillations)
        all.append (py::dict ("mode"_a = each.mode, "start_s"_a = each.start, "end_s"_a = each.end,
                              "growth_per_s"_a = each.growth, "angular_frequency_rad_s"_a = each.angularFrequency,
                              "in_phase"_a = each.inPhase, "quadrature"_a = each.quadrature));

    return all;
}

/** The field at the (first) focus by the closed form: N_p, m/s. */
Eigen::VectorXd predictedField (const DesignedFocus& design)
{
    const auto& [wide, made] = design.made;
    const auto states = predictStates (wide.model, made.program, made.moments.front().time);
    return wide.model.shapes * modalVelocities (wide.model, states);
}

std::string designText (const DesignedFocus& design)
{
    return designFileText (design, designedPower (design));
}

bool isPlate (const ModalModel& model)
{
    return model.surface.kind == SurfaceKind::plate;
}

/** The wanted, the represented and a third field over the surface by `plot_values`: members "..._field_m_s". */
auto plotsFields (const std::string& third)
{
    return [third] (const py::object& self, const ModalModel& model, const FocusDesign& design)
    {
        py::dict values;

        for (const auto& name : { std::string ("wanted"), std::string ("represented"), third })
            values[name.c_str()] = self.attr ((name + "_field_m_s").c_str()).attr ("__mul__") (milli);

        return plotBy ("plot_values") (isPlate (model), self.attr ("points_m"), values,
                                       design.description.name + " on " + model.name, "mm/s");
    };
}

void bindDesigned (py::module_& module)
{
    using Value = DesignedFocus;
    constexpr const char* about = "The voltages of a focus, not yet played: N_d drives, N_b ceramics, N_p points. Made "
                                  "by :func:`antinode.design`.\n\n"
                                  "Arrays are read-only views of the memory of the design, which they keep alive.";
    const auto plot = plotsFields ("predicted");
    const auto document = [] (const Value& value)
    { return designToJson (value.made.design, designedModel (value.made.wide)); };
    ResultClass<Value> (module, "Design", about)
        .isShownAs (
            [] (const Value& value)
            {
                return "Design '" + value.made.design.description.name + "' on '" + value.made.wide.model.name
                       + "': " + inWords (peakVoltage (value.made.design)) + " V";
            })
        .has ("device", "The name of the device.", [] (const Value& value) { return value.made.wide.model.name; })
        .has ("focus", "The name of the focus.", [] (const Value& value) { return value.made.design.description.name; })
        .has ("peak_voltage_V", "The largest voltage of any ceramic, V.",
              [] (const Value& value) { return peakVoltage (value.made.design); })
        .has ("allocation_V", "N_b x N_d: ``U_i(t) = sum_l allocation_V[i, l] value_l(t)``, V. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.made.design.program.allocation; })
        .has ("oscillations",
              "N_d drives: mode (from 0), start_s, end_s, growth_per_s, angular_frequency_rad_s, in_phase, "
              "quadrature.\n\n"
              "With tau = t - start_s, for start_s <= t < end_s, else 0:\n"
              "``exp(growth tau) (in_phase sin(angular_frequency tau) + quadrature cos(angular_frequency tau))``.",
              &oscillations, "list[dict[str, float]]")
        .has ("voltage_limits_V", "N_b: the limit of each ceramic, V. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.made.design.program.voltageLimits; })
        .has ("points_m", "N_p x 2: x and y of the points of the surface, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixX2d& { return value.made.wide.model.surface.points; })
        .has ("wanted_field_m_s", "N_p: the wanted velocity at the (first) focus, m/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.made.design.target.field; })
        .has ("represented_field_m_s", "N_p: its part that the controlled modes represent, m/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.made.design.truncatedField; })
        .has ("predicted_field_m_s",
              "N_p: the field of the voltages by the closed form, m/s (Docs/Theory.md, section 3.1).",
              [] (const Value& value) { return Work (py::none()).run ([&] { return predictedField (value); }); })
        .has ("certificate",
              "How near the allocation is to the optimum: status, gap, bound, peak_ratio and more, as in "
              "``design.json``.",
              [document] (const Value& value) { return Json { document (value)["certificate"].dump() }; })
        .has ("numbers",
              "All of ``design.json`` except its power: choices with reasons, warnings, controlled modes, lower bound.",
              [document] (const Value& value) { return Json { document (value).dump() }; })
        .does ("to_dict(self) -> dict[str, Any]",
               "All of ``design.json``, with the electrical power, which takes a render.",
               [] (const Value& value)
               { return toPython (Json { Work (py::none()).run ([&] { return designText (value); }) }); })
        .saves ("folder", "Writes ``design.json``, the same bytes as ``antinode design --out``.",
                [] (const Value& value, const Path& path)
                {
                    OutputFolder folder (path);
                    folder.write ("design.json", designText (value));
                    folder.commit();
                })
        .draws ("png", pictureHelp, &designPicture)
        .does ("plot(self) -> Any", "Wanted, represented and predicted field as a Matplotlib figure.",
               [plot] (const py::object& self)
               {
                   const auto& value = self.cast<const Value&>();
                   return plot (self, value.made.wide.model, value.made.design);
               })
        .bound.def_property_readonly (
            "samples_V",
            [] (const py::object& self)
            {
                const auto& held = self.cast<const Value&>().made.design.program.samples;
                return held ? py::object (viewOf (held->values, self)) : py::none();
            },
            "N_b x N_s: the samples of a free waveform, V; None where there are none. A view.");
    keepStub ("    @property\n    def samples_V(self) -> Optional[Floats]: ...\n");
    bindTask<FocusRequest> (module, "design", designTask, "Design", &design);
}

/** N_probes x 2, mm */
Eigen::MatrixX2d probesInMillimetres (const RenderedDesign& value)
{
    const auto& probes = value.focus.probes;
    Eigen::MatrixX2d places (static_cast<Eigen::Index> (probes.size()), 2);

    for (std::size_t i = 0; i < probes.size(); ++i)
        places.row (static_cast<Eigen::Index> (i)) << probes[i].first * milli, probes[i].second * milli;

    return places;
}

std::string voltagesPicture (const RenderedDesign& value, const PictureStyle& style)
{
    constexpr int heightPerCeramic = 44, heightOfAxes = 110; // pixels
    const auto& focus = value.focus;
    const auto height = heightOfAxes + heightPerCeramic * static_cast<int> (focus.render.voltages.rows());
    return picture (voltagesChart (focus.model, focus.design.program, focus.render), style, height);
}

void bindRendered (py::module_& module)
{
    using Value = RenderedDesign;
    constexpr const char* about = "A focus as the plate model played it: N_b ceramics, N_s samples, N_p points. Made "
                                  "by :func:`antinode.render`.\n\n"
                                  "Arrays are read-only views of the memory of the render, which they keep alive.";
    const auto plot = plotsFields ("reached");
    ResultClass<Value> (module, "Rendered", about)
        .isShownAs (
            [] (const Value& value)
            { return "Rendered '" + value.focus.design.description.name + "' on '" + value.focus.model.name + "'"; })
        .has (
            "design", "The design that was played.",
            [] (const Value& value) { return std::const_pointer_cast<DesignedFocus> (value.design); }, "Design")
        .has ("scores", "All numbers of ``summary.json``: v_score, field_error, contrast, felt, power and more.",
              [] (const Value& value) { return Json { summaryToJson (value.focus, value.outcome).dump() }; })
        .has ("sample_rate_Hz", "Hz.", [] (const Value& value) { return value.focus.render.sampleRate; })
        .has ("focus_sample", "The sample (from 0) of the first focus.",
              [] (const Value& value) { return value.focus.render.focusSample; })
        .has ("times_s", "N_s: the times of the samples from the trigger, s.",
              [] (const Value& value)
              {
                  const auto& render = value.focus.render;
                  const auto count = render.voltages.cols();
                  return Eigen::VectorXd (Eigen::VectorXd::LinSpaced (count, 0, static_cast<double> (count - 1))
                                          / render.sampleRate);
              })
        .has ("voltages_V", "N_b x N_s: the voltages that ceramics act on, after the limiter, V. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.focus.render.voltages; })
        .has ("output_voltages_V",
              "N_b x N_s: the voltages to play, V: the same, compensated for lags of ceramics if the device has any. A "
              "view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return outputVoltages (value.focus); })
        .has ("probes_mm", "N_probes x 2: x and y of the probes, mm.", &probesInMillimetres)
        .has ("probe_velocities_m_s", "N_probes x N_s: the velocity of the surface at the probes, m/s. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.focus.render.probeVelocities; })
        .has ("modal_velocities", "Modes x N_s, m/s kg^1/2; imaginary parts of complex modes follow. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.focus.render.modalVelocities; })
        .has ("points_m", "N_p x 2: x and y of the points of the surface, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixX2d& { return value.focus.model.surface.points; })
        .has ("wanted_field_m_s", "N_p: the wanted velocity at the (first) focus, m/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.focus.design.target.field; })
        .has ("represented_field_m_s", "N_p: its part that the controlled modes represent, m/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.focus.design.truncatedField; })
        .has ("reached_field_m_s", "N_p: the velocity that the plate model reached, m/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.focus.reachedField; })
        .does (
            "save(self, folder: Folder, *, format: str = 'wav', report: bool = True, figures: Sequence[str] = ()) -> "
            "None",
            "Writes the folder of ``antinode render``, the same bytes.\n\nArgs:\n"
            "    folder: made where it is missing.\n"
            "    format: of the voltages: 'wav', 'csv', 'mat', 'tfw'.\n"
            "    report: whether ``report.html`` is written.\n"
            "    figures: 'svg', 'pdf': the figures of the report for print.\n\n"
            "Raises:\n    InputError: the folder cannot be written, or a format cannot hold the samples.",
            [] (const Value& value, const Path& folder, const std::string& format, bool hasReport,
                const py::iterable& wantedFigures)
            {
                const auto figures = py::list (wantedFigures).cast<std::vector<std::string>>();
                workAway ([&] { writeRendered (folder, value.focus, value.outcome, { format, hasReport, figures }); });
            },
            py::arg ("folder"), py::kw_only(), py::arg ("format") = "wav", py::arg ("report") = true,
            py::arg ("figures") = py::tuple())
        .draws ("png", pictureHelp,
                [] (const Value& value, const PictureStyle& style)
                {
                    const auto& focus = value.focus;
                    return fieldPicture (focus.model, focus.design, focus.reachedField, style);
                })
        .draws ("voltages_png", "The voltages of all ceramics as the bytes of a PNG file. Args: as :meth:`png`.",
                &voltagesPicture)
        .does ("plot(self) -> Any", "Wanted, represented and reached field as a Matplotlib figure.",
               [plot] (const py::object& self)
               {
                   const auto& value = self.cast<const Value&>();
                   return plot (self, value.focus.model, value.focus.design);
               });
    bindTask<RenderRequest> (module, "render", renderText, "Rendered", &render);
}

/** One of the scores of the design that was asked about, on each device. */
auto scores (double FocusScore::*score)
{
    return [score] (const DesignOnDevices& value)
    {
        const auto& draws = value.tolerances.back().tolerance.draws;
        Eigen::VectorXd numbers (static_cast<Eigen::Index> (draws.size()));
        std::transform (draws.begin(), draws.end(), numbers.begin(), [&] (const auto& each) { return each.*score; });
        return numbers;
    };
}

nlohmann::ordered_json toleranceNumbers (const DesignOnDevices& value)
{
    return toleranceToJson (value.model, value.focus(), value.tolerances);
}

void bindTolerance (py::module_& module)
{
    using Value = DesignOnDevices;
    constexpr const char* about =
        "A design on N devices that differ from the model. Made by :func:`antinode.tolerance`.\n\n"
        "Where the focus is robust (``allocation.robust``), its design without robustness is compared on the same "
        "devices.";
    ResultClass<Value> (module, "Tolerance", about)
        .isShownAs (
            [] (const Value& value)
            {
                return "Tolerance of '" + value.focus() + "' on "
                       + std::to_string (value.tolerances.back().tolerance.draws.size()) + " devices";
            })
        .has (
            "design", "The design that was played on all devices.",
            [] (const Value& value) { return std::const_pointer_cast<DesignedFocus> (value.design); }, "Design")
        .has ("field_errors",
              "N: RMS of reached minus represented field over that of the represented one, on each device.",
              scores (&FocusScore::fieldError))
        .has ("v_scores", "N: correlation of the reached with the represented field, on each device; 1 is best.",
              scores (&FocusScore::vScore))
        .has ("peak_ratios", "N: reached over wanted velocity at the peak, on each device.",
              scores (&FocusScore::peakRatio))
        .has ("numbers",
              "All of ``tolerance.json``: the spread, percentiles of all designs, and the largest causes of error.",
              [] (const Value& value) { return Json { toleranceNumbers (value).dump() }; })
        .has (
            "causes", "Causes of the error in the device, the largest first: mode (from 1), kind, field_error.",
            [] (const Value& value) { return Json { toleranceNumbers (value)["designs"].back()["causes"].dump() }; },
            "list[dict[str, Any]]")
        .saves ("folder",
                "Writes the folder of ``antinode design --tolerance``: ``design.json``, ``tolerance.json``, "
                "``tolerance.html``.",
                [] (const Value& value, const Path& path)
                {
                    OutputFolder folder (path);
                    folder.write ("design.json", designText (*value.design));
                    writeTolerances (folder, value);
                    folder.commit();
                })
        .plots ("plot_tolerance",
                "How many devices have at most this field error, as a Matplotlib figure; one curve per design.")
        .reports ([] (const Value& value) { return toleranceReport (value.model, value.focus(), value.tolerances); })
        .bound.def ("__str__", &tolerancesInWords);
    bindTask<ToleranceRequest> (module, "tolerance", toleranceText, "Tolerance", &tolerance);
}

Json onFront (const DesignTradeoff& value)
{
    auto front = nlohmann::ordered_json::array();
    const auto document = tradeoffDocument (value);

    for (const auto& point : document["points"])
        if (point.value ("on_front", false))
            front.push_back (point);

    return { front.dump() };
}

void bindTradeoff (py::module_& module)
{
    using Value = DesignTradeoff;
    ResultClass<Value> (
        module, "Tradeoff",
        "Designs of one focus by all methods and growths, or by the weight of felt levels elsewhere. Made "
        "by :func:`antinode.tradeoff`.")
        .isShownAs ([] (const Value& value)
                    { return "Tradeoff of '" + value.focus + "': " + std::to_string (value.designs()) + " designs"; })
        .has ("numbers",
              "All of ``tradeoff.json``: the points, and the lower bound of the voltage for any waveform, V.",
              [] (const Value& value) { return Json { tradeoffDocument (value).dump() }; })
        .has (
            "points",
            "The designs: method, peak_voltage_V, time_in_motion_ms, field_error_truncated, on_front and more; of a "
            "focus "
            "with ``felt`` weight, peak_voltage_V, contrast_dB and more. ``failure`` says why there is no design.",
            [] (const Value& value) { return Json { tradeoffDocument (value)["points"].dump() }; },
            "list[dict[str, Any]]")
        .has ("front", "The Pareto-optimal points in voltage and time; none for a focus with ``felt``.", &onFront,
              "list[dict[str, Any]]")
        .saves ("folder",
                "Writes the folder of ``antinode design --tradeoff``: ``tradeoff.json``, ``tradeoff.csv``, "
                "``tradeoff.html``.",
                [] (const Value& value, const Path& folder) { writeTradeoff (folder, value); })
        .plots ("plot_tradeoff",
                "Peak voltage against time in motion, or against felt contrast, as a Matplotlib figure.")
        .reports (&tradeoffPage)
        .bound.def ("__str__", &tradeoffInWords);
    bindTask<FocusRequest> (module, "tradeoff", tradeoffText, "Tradeoff", &tradeoff);
}
} // namespace

std::string designPicture (const DesignedFocus& design, const PictureStyle& style)
{
    return fieldPicture (design.made.wide.model, design.made.design, predictedField (design), style);
}

void bindDesign (py::module_& module)
{
    bindDesigned (module);
    bindRendered (module);
    bindTolerance (module);
    bindTradeoff (module);
}

namespace
{
namespace py = pybind11;
using Value = PerformedWaveforms;

std::vector<std::string> fingerNames (const Value& value)
{
    std::vector<std::string> names;

    for (std::size_t p = 0; p < value.scores.fingers.size(); ++p)
        names.push_back (fingerName (value.design.description, p));

    return names;
}
} // namespace

void bindPerform (py::module_& module)
{
    constexpr const char* about = "Waveforms at fingers as the plate model played them: N_b ceramics, N_s samples, N_f "
                                  "fingers, those with tracks "
                                  "first. Made by :func:`antinode.perform`.\n\n"
                                  "Arrays are read-only views of the memory of the result, which they keep alive.";
    ResultClass<Value> (module, "Performed", about)
        .isShownAs (
            [] (const Value& value)
            {
                return "Performed '" + value.design.description.name + "' on '" + value.judge.name
                       + "': " + std::to_string (value.scores.fingers.size()) + " fingers";
            })
        .has ("fingers", "N_f names, as in ``report.html``.", &fingerNames)
        .has ("sample_rate_Hz", "Hz.", [] (const Value& value) { return value.played.sampleRate; })
        .has ("trigger_sample", "The sample (from 0) of the trigger, from which tracks count their time.",
              [] (const Value& value) { return value.played.trigger; })
        .has ("voltages_V", "N_b x N_s: the voltages that ceramics act on, V. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.design.voltages.values; })
        .has ("output_voltages_V",
              "N_b x N_s: the voltages to play, V: the same, compensated for lags of ceramics if the device has any. A "
              "view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return outputVoltages (value); })
        .has ("displacements_m",
              "N_f x samples: motion of the surface at the fingers, m, including the ringing. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.played.displacements; })
        .has ("wanted_m", "Samples from the trigger on x N_f: the wanted motion, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixXd& { return value.design.wanted; })
        .has ("scores", "All numbers of ``summary.json``: errors, levels and volts.",
              [] (const Value& value) { return Json { performedToJson (value).dump() }; })
        .does (
            "save(self, folder: Folder, *, report: bool = True) -> None",
            "Writes the folder of ``antinode perform``, the same bytes.\n\n"
            "Raises:\n    InputError: the folder cannot be written.",
            [] (const Value& value, const std::filesystem::path& folder, bool hasReport)
            { workAway ([&] { writePerformed (folder, value, { hasReport }); }); },
            py::arg ("folder"), py::kw_only(), py::arg ("report") = true)
        .plots ("plot_fingers", "The motion at each finger over time as a Matplotlib figure, with the wanted motion.");
    bindTask<PerformRequest> (module, "perform", performText, "Performed", &perform);
}
} // namespace antinode
