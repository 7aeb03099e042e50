#include "Commands.h"
#include "IdentifyFiles.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_library/Inputs.h>
#include <antinode_reports/IdentificationTables.h>

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

IdentificationResult identifyShowing (const IdentifyOptions& options)
{
    const auto against =
        options.against.empty() ? std::optional<DeviceDescription>() : std::optional (loadDevice (options.against, {}));
    Progress progress (options.isQuiet);
    return identifyFiles (options, against,
                          [&] (const std::string& what, double share) { progress.show (what, share); });
}

void runIdentify (const IdentifyOptions& options, bool hasReport)
{
    if (! options.transferFile.empty() && options.against.empty())
        throw InputError ("--transfer", "needs a computed device; allowed only with --against DEVICE");

    const auto result = identifyShowing (options);
    writeIdentified (result, options, hasReport);

    if (! options.isQuiet)
        print (result);
}
} // namespace

void addIdentifyCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("identify", "Finds the modes in measured frequency responses; writes a device file");
    auto options = std::make_shared<IdentifyOptions>();
    addIdentifyOptions (*command, *options);
    command->callback ([options, command] { runIdentify (*options, command->count ("--report") > 0); });
}
} // namespace antinode
