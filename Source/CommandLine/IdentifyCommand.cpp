#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_reports/IdentificationTables.h>
#include <antinode_tasks/Identify.h>

#include <cstdio>
#include <memory>

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
} // namespace antinode
