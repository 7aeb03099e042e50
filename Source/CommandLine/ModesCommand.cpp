#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_base/NumberText.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/MatlabTables.h>
#include <antinode_documents/ModeTable.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_identification/FrequencyDrift.h>
#include <antinode_reports/ModesReport.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_structure/DescribedModel.h>
#include <antinode_structure/DeviceKind.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

namespace antinode
{
namespace
{
struct ModesOptions
{
    DeviceDescription device;
    std::optional<int> count;
    std::filesystem::path csvFile, matlabFile, universalFile, reportFolder; ///< None if empty.
    bool usesCache = true, isJson = false;
};

nlohmann::ordered_json modesJson (const ModalModel& model, const std::string& kind, double milliseconds)
{
    auto modes = nlohmann::ordered_json::array();
    const auto collinearity = phaseCollinearities (model);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const Eigen::RowVectorXd participation = model.participation.row (k);
        nlohmann::ordered_json mode;
        mode["frequency_Hz"] = model.frequencyHz (k);
        mode["damping_ratio"] = model.dampingRatios[k];
        mode["participation_per_V"] = std::vector<double> (participation.begin(), participation.end());

        if (model.hasComplexModes())
        {
            const Eigen::RowVectorXd imaginary = model.participation.row (model.modes() + k);
            mode["participation_imaginary_per_V"] = std::vector<double> (imaginary.begin(), imaginary.end());
            mode["phase_collinearity"] = collinearity[k];
        }

        if (model.frequencyErrors.size() > 0)
            mode["error_estimate_relative"] = model.frequencyErrors[k];

        modes.push_back (mode);
    }

    nlohmann::ordered_json json { { "device", model.name }, { "kind", kind }, { "modes", modes } };

    if (const auto error = usualModelError (model))
        json["usual_model_error_relative"] = *error;

    json.update ({ { "rigid_body_modes", model.rigidBodyModes },
                   { "unknowns", model.unknowns },
                   { "warnings", model.warnings },
                   { "time_ms", milliseconds } });
    return json;
}

void printTable (const ModalModel& model)
{
    const auto modelError = usualModelError (model);
    std::printf ("%s: %td modes, %td ceramics, %d rigid-body modes\n", model.name.c_str(), model.modes(),
                 model.actuators(), model.rigidBodyModes);
    std::printf ("%5s %14s %8s %16s%s   %s\n", "mode", "frequency/Hz", "Q",
                 modelError ? "error of solver" : "frequency error", modelError ? "  of model" : "",
                 "largest participation, N kg^-1/2 / V");

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        Eigen::Index best = 0;
        const auto largest = model.actuators() > 0 ? model.participation.row (k).cwiseAbs().maxCoeff (&best) : 0.0;
        const auto error = model.frequencyErrors.size() > 0 ? formatted ("%.1e", model.frequencyErrors[k]) : "unknown";
        const auto ofModel = modelError ? formatted ("%10.1e", *modelError) : "";
        std::printf ("%5td %14.3f %8.1f %16s%s %14.4g (%s)\n", k + 1, model.frequencyHz (k),
                     0.5 / model.dampingRatios[k], error.c_str(), ofModel.c_str(), largest,
                     model.actuators() > 0 ? model.ceramics[static_cast<std::size_t> (best)].name.c_str() : "none");
    }

    if (modelError)
        std::printf ("Errors are relative: of the numerical solution; of the model, the usual difference of devices "
                     "from their description.\n");

    if (model.origin.source == ModeSource::drawn)
        std::printf ("Drawn, not measured: 'antinode retune' with responses of six points gives frequencies, damping "
                     "and participations of the device itself.\n");

    for (const auto& warning : model.warnings)
        std::printf ("%s\n", warning.c_str());
}

void writeReport (const std::filesystem::path& target, const ModalModel& model, const std::vector<PathPiece>& elastic)
{
    OutputFolder folder (target);
    folder.write ("report.html", renderReport (modesReport (model, elastic)));
    folder.commit();
}

void listModes (const ModesOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    const auto model = solveDevice (options.device, options.count, options.usesCache);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;

    if (! options.reportFolder.empty())
        writeReport (options.reportFolder, model, elasticPieces (options.device));

    if (! options.csvFile.empty())
        writeWholeFile (options.csvFile, encodeModeTable (model));

    if (! options.matlabFile.empty())
        writeWholeFile (options.matlabFile, encodeModesForMatlab (model));

    if (! options.universalFile.empty())
        writeWholeFile (options.universalFile, encodeUniversalFile (modeSets (model)));

    if (options.isJson)
        std::printf ("%s\n", modesJson (model, deviceKind (options.device), elapsed.count()).dump (2).c_str());
    else
        printTable (model);
}
} // namespace

void addModesCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("modes", "Lists the modes of a device");
    auto options = std::make_shared<ModesOptions>();
    const auto read = addFields (
        *command,
        { Field ("device", &options->device, "Device: an embedded name or a .json file").usually ("staple"),
          Field ("--count", &options->count, "Number of flexible modes").within (1, 500).by ("as the device says"),
          Field ("--csv", &options->csvFile, "Also writes the modes as CSV to a file").written ("FILE"),
          Field ("--mat", &options->matlabFile, "Also writes modes and shapes as a MATLAB file").written ("FILE"),
          Field ("--uff", &options->universalFile, "Also writes frequencies and shapes as a Universal File")
              .written ("FILE"),
          cacheField (options->usesCache), Field ("--json", &options->isJson, "Writes JSON to standard output"),
          Field ("--report", &options->reportFolder, "Writes a report with figures of the modes into a folder")
              .written ("DIR") });
    command->callback (
        [options, read]
        {
            read();
            listModes (*options);
        });
}
} // namespace antinode
