#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/TableExport.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_identification/Comparison.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_reports/IdentificationTables.h>
#include <antinode_reports/ModesReport.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_structure/DescribedModel.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_tasks/Identify.h>
#include <antinode_tasks/Import.h>
#include <antinode_tasks/Retune.h>
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
void print (const IdentificationResult& result)
{
    const auto& modes = result.modes;
    std::printf ("%s: %td modes from %s to %s Hz, reconstruction error %s, delay %s us\n%s", result.model.name.c_str(),
                 modes.modes(), inWords (modes.minimumFrequency).c_str(), inWords (modes.maximumFrequency).c_str(),
                 reconstructionError (result).c_str(), delayInWords (modes).c_str(),
                 tableText (modeTable (result)).c_str());

    if (! modes.kindReason.empty())
        std::printf ("%s\n", modes.kindReason.c_str());

    if (result.comparison)
        std::printf ("\n%s", tableText (pairTable (result)).c_str());

    for (const auto& warning : collectWarnings (result))
        std::printf ("Warning: %s\n", warning.c_str());
}

/** Beside the device file, where the option says none. */
std::filesystem::path reportBeside (const IdentifyRequest& request, const std::filesystem::path& device)
{
    auto path = device.empty() ? std::filesystem::path (request.name) : device;
    return path.replace_extension (".html");
}

struct IdentifyOptions
{
    IdentifyRequest request;
    IdentifiedFiles files;
    bool isQuiet = false;
};
} // namespace

void addIdentifyCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand (identifyText.name, "Finds the modes in measured frequency responses; writes a device file");
    auto options = std::make_shared<IdentifyOptions>();
    auto& files = options->files;
    auto all = fields (options->request);
    append (
        all,
        { Field ("--out", &files.device, "Device file to write").written ("DEVICE.json"),
          Field ("--report", &files.report,
                 "Writes a report with figures and a diagram to pick modes in a browser; default name: that "
                 "of the device file, .html")
              .written ("FILE.html"),
          Field ("--uff", &files.universalFile, "Writes frequencies and shapes as a Universal File").written ("FILE"),
          Field ("--transfer", &files.transferred,
                 "Writes the computed device with the measured frequencies, damping ratios and participations")
              .written ("DEVICE.json"),
          quietField (options->isQuiet) });
    const auto read = addFields (*command, all);
    auto* const report = command->get_option ("--report")->expected (0, 1);
    command->callback (
        [options, report, read]
        {
            read();

            if (report->count() > 0 && options->files.report.empty())
                options->files.report = reportBeside (options->request, options->files.device);

            if (! options->files.transferred.empty() && ! options->request.against)
                throw InputError ("--transfer", "needs a computed device; allowed only with --against DEVICE");

            Progress progress (options->isQuiet);
            const auto result = identify (options->request, progress.shown());
            writeIdentified (result, options->files);

            if (! options->isQuiet)
                print (result);
        });
}

namespace
{
struct ImportOptions
{
    ImportRequest request;
    std::filesystem::path file;
    bool isQuiet = false;
};

void print (const ImportedDevice& device)
{
    const auto& model = device.model;
    std::printf (
        "%s: %td %s modes, %.2f to %.1f Hz, %td ceramics, %td points (of %td nodes on the surface, %td in all)\n",
        model.name.c_str(), model.modes(), model.hasComplexModes() ? "complex" : "real", model.frequencyHz (0),
        model.frequencyHz (model.modes() - 1), model.actuators(), model.points(), device.nodesOfSurface,
        device.meshNodes);

    if (device.leftOut > 0)
        std::printf ("  left out: %d modes that do not move the surface along its normal\n", device.leftOut);

    std::printf ("  mass that the surface represents, from the shapes: %s g", inWords (1000 * device.mass).c_str());

    if (device.totalMass)
        std::printf ("; the program's table: %s g", inWords (1000 * *device.totalMass).c_str());

    std::printf ("\n");

    for (std::size_t i = 0; i < device.staticErrors.size(); ++i)
        std::printf ("  static displacement by ceramic %zu: the modes give it to %s %%\n", i + 1,
                     inWords (100 * device.staticErrors[i]).c_str());

    for (const auto& warning : device.warnings)
        std::printf ("Warning: %s\n", warning.c_str());
}
} // namespace

void addImportCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (importText.name, importText.summary);
    auto options = std::make_shared<ImportOptions>();
    auto all = fields (options->request);
    append (all, { Field ("--out", &options->file, "Device file to write").written ("DEVICE.json").required(),
                   quietField (options->isQuiet) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            const auto device = importDevice (options->request, {});
            writeWholeFile (options->file, importedDeviceText (device));

            if (! options->isQuiet)
                print (device);
        });
}

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

namespace
{
/** Of responses that are not the device's, and of points that fit it much worse than the others: elsewhere, turned
   over, or loose. */
void warnOfMisfit (const RetunedModel& retuned)
{
    constexpr double poor = 0.3, worseThanOthers = 3, quarter = -12; // dB
    const auto& errors = retuned.pointErrors;

    if (retuned.reconstructionError > quarter)
        std::printf ("  warning: more than a quarter of the measured responses is not explained; are device, points, "
                     "and order and "
                     "signs of the ceramics right?\n");

    const auto usual = median ({ errors.begin(), errors.end() });

    for (Eigen::Index p = 0; p < errors.size(); ++p)
        if (errors[p] > poor && errors[p] > worseThanOthers * usual)
            std::printf ("  warning: point %td: %.0f %% of its responses are not explained; is it where the file says, "
                         "and its sign right?\n",
                         p + 1, 100 * errors[p]);
}

void print (const ModalModel& before, const RetunedModel& retuned)
{
    constexpr double million = 1e6, percent = 100;
    std::printf ("%s: reconstruction error %.1f dB, delay %.3f us\n", retuned.model.name.c_str(),
                 retuned.reconstructionError, million * retuned.delay);
    std::printf ("%5s %14s %14s %12s %12s\n", "mode", "before (Hz)", "now (Hz)", "change (ppm)", "damping (%)");

    for (Eigen::Index k = 0; k < retuned.model.modes(); ++k)
        std::printf ("%5td %14.3f %14.3f %12.1f %12.2f%s\n", k + 1, before.frequencyHz (k),
                     before.frequencyHz (k) * (1 + retuned.frequencyChanges[k]), million * retuned.frequencyChanges[k],
                     percent * retuned.dampingChanges[k],
                     retuned.found[static_cast<std::size_t> (k)] ? "" : "  not found, shifted with its neighbours");

    for (Eigen::Index i = 0; i < retuned.participationScales.size(); ++i)
        std::printf ("ceramic %s has %.2f %% of its former participation\n",
                     before.ceramics[static_cast<std::size_t> (i)].name.c_str(),
                     percent * retuned.participationScales[i]);
}
} // namespace

void addRetuneCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (retuneText.name, retuneText.summary);
    auto request = std::make_shared<RetuneRequest>();
    auto file = std::make_shared<std::filesystem::path>();
    auto options = fields (*request);
    options.push_back (Field ("--out", file.get(), "Device file to write").written ("DEVICE.json").required());
    command->callback (
        [request, file, read = addFields (*command, options)]
        {
            read();
            const auto retuned = retune (*request, {});
            writeWholeFile (*file, retunedDeviceText (retuned));
            print (retuned.before, retuned.now);

            for (const auto& remark : retuned.remarks)
                std::printf ("  note: %s\n", remark.c_str());

            warnOfMisfit (retuned.now);
        });
}
} // namespace antinode
