#include "Commands.h"
#include "CommonOptions.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_identification/Retuning.h>
#include <antinode_library/Inputs.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct RetuneOptions
{
    std::string device, outputFile;
    std::vector<std::string> files;
    bool usesCache = true;
};

void print (const ModalModel& before, const RetunedModel& retuned)
{
    constexpr double million = 1e6, percent = 100;
    std::printf ("%s: reconstruction error %.1f dB, delay %.3f us\n", retuned.model.name.c_str(),
                 retuned.reconstructionError, million * retuned.delay);
    std::printf ("%5s %14s %14s %12s %12s\n", "mode", "before (Hz)", "now (Hz)", "change (ppm)", "damping (%)");

    for (Eigen::Index k = 0; k < retuned.model.modes(); ++k)
        std::printf ("%5td %14.3f %14.3f %12.1f %12.2f%s\n", k + 1, before.frequencyHz (k),
                     retuned.model.frequencyHz (k), million * retuned.frequencyChanges[k],
                     percent * retuned.dampingChanges[k],
                     retuned.found[static_cast<std::size_t> (k)] ? "" : "  not found, shifted with its neighbours");

    for (Eigen::Index i = 0; i < retuned.participationScales.size(); ++i)
        std::printf ("ceramic %s has %.2f %% of its former participation\n",
                     before.ceramics[static_cast<std::size_t> (i)].name.c_str(),
                     percent * retuned.participationScales[i]);
}

void retuneDevice (const RetuneOptions& options)
{
    const auto model = solveDevice (loadDevice (options.device, {}), {}, options.usesCache);
    std::vector<MeasurementFile> files;

    for (const auto& file : options.files)
        files.push_back (readMeasurement (file, CsvForm::byHeadings));

    const auto retuned = retune (model, mergedResponses (files, {}).responses, {});
    writeWholeFile (options.outputFile, modalDeviceToJson (retuned.model, "Retuned from a few points").dump (2) + "\n");
    print (model, retuned);
}
} // namespace

void addRetuneCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("retune", "Updates a drifted device from the responses of a few points");
    auto options = std::make_shared<RetuneOptions>();
    command->add_option ("device", options->device, "Device before the drift: an embedded name or a .json file")
        ->required();
    command->add_option ("files", options->files, "Frequency responses of a few points, as written by frf and measure")
        ->required();
    command->add_option ("--out", options->outputFile, "Device file to write")->required()->type_name ("DEVICE.json");
    addCacheFlag (*command, options->usesCache);
    command->callback ([options] { retuneDevice (*options); });
}
} // namespace antinode
