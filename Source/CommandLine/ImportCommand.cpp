#include "Commands.h"
#include "FieldOptions.h"

#include <antinode_base/NumberText.h>
#include <antinode_tasks/Import.h>
#include <antinode_text/OutputFolder.h>

#include <cstdio>
#include <memory>

namespace antinode
{
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
} // namespace antinode
