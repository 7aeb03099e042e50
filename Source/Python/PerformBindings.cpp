#include "Bindings.h"
#include "Keywords.h"
#include "ResultClass.h"

#include <antinode_base/NumberText.h>
#include <antinode_tasks/Perform.h>

#include <nlohmann/json.hpp>

namespace antinode
{
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
