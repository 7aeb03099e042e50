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
    std::printf ("%5s %14s %14s %12s %12s\n", "mode", "was (Hz)", "is (Hz)", "change (ppm)", "damping (%)");

    for (Eigen::Index k = 0; k < retuned.model.modes(); ++k)
        std::printf ("%5td %14.3f %14.3f %12.1f %12.2f%s\n", k + 1, before.frequencyHz (k),
                     retuned.model.frequencyHz (k), million * retuned.frequencyChanges[k],
                     percent * retuned.dampingChanges[k],
                     retuned.found[static_cast<std::size_t> (k)] ? "" : "  not seen, moved with its neighbours");

    for (Eigen::Index i = 0; i < retuned.participationScales.size(); ++i)
        std::printf ("ceramic %s is %.2f %% as strong as it was\n",
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
    auto* command = app.add_subcommand ("retune", "Updates a device that has drifted from responses of a few points");
    auto options = std::make_shared<RetuneOptions>();
    command->add_option ("device", options->device, "The device as it was: an embedded name or a .json file")
        ->required();
    command->add_option ("files", options->files, "Frequency responses of a few points, as frf and measure write them")
        ->required();
    command->add_option ("--out", options->outputFile, "The device file to write")
        ->required()
        ->type_name ("DEVICE.json");
    addCacheFlag (*command, options->usesCache);
    command->callback ([options] { retuneDevice (*options); });
}
} // namespace antinode
