#include "BoundaryOption.h"
#include "Commands.h"
#include "ImportFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_text/OutputFolder.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct ImportCommandOptions
{
    ImportOptions wanted;
    std::string outputFile;
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

void importDevice (const ImportCommandOptions& options)
{
    const auto device = importFiles (options.wanted);
    writeWholeFile (options.outputFile, importedDeviceText (device));

    if (! options.isQuiet)
        print (device);
}

void addSurfaceOptions (CLI::App& command, ImportOptions& options)
{
    command.add_option ("--normal", options.normal, "Axis that is normal to the surface")
        ->check (CLI::IsMember ({ "x", "y", "z" }))
        ->capture_default_str();
    command.add_option ("--side", options.side, "Which plane is touched: the highest along that axis, or the lowest")
        ->check (CLI::IsMember ({ "top", "bottom" }))
        ->capture_default_str();
    command
        .add_option ("--flatness-mm", options.flatness,
                     "How far nodes of the surface may lie behind its plane, mm; default: a thousandth of its extent")
        ->check (CLI::PositiveNumber);
    addOutlineOption (command, options.outline);
    command
        .add_option ("--points", options.settings.side.maximumPoints, "Points at most; more nodes are thinned evenly")
        ->check (CLI::Range (3, 20000))
        ->capture_default_str();
}
} // namespace

void addImportCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "import", "Makes a device of the modes and reaction forces that a finite-element program computed");
    auto all = std::make_shared<ImportCommandOptions>();
    auto* const options = &all->wanted;
    auto& settings = options->settings;
    command->add_option ("files", options->files, "CalculiX .frd and .dat files, or universal files")
        ->required()
        ->type_name ("FILES");
    command->add_option ("--out", all->outputFile, "Device file to write")->required()->type_name ("DEVICE.json");
    command->add_option ("--name", settings.name, "Name of the device")->capture_default_str();
    command->add_option ("--units", options->units, "Units of the files: SI (m, kg, N, s) or mm (mm, t, N, s)")
        ->check (CLI::IsMember ({ "SI", "mm" }))
        ->capture_default_str();
    addSurfaceOptions (*command, *options);
    command
        ->add_option ("--case-voltage-v", settings.caseVoltage,
                      "Voltage at which the ceramics of the static cases strain, V")
        ->check (CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option ("--damping-ratio", settings.dampingRatio,
                      "Damping ratio of modes for which the program says none")
        ->check (CLI::Range (1e-6, 0.9))
        ->capture_default_str();
    command->add_option ("--voltage-limit-v", settings.voltageLimit, "Voltage limit of every ceramic, V")
        ->check (CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option ("--full-scale-v", options->fullScaleVoltage,
                      "Voltage of a sample of 1, V; default: the voltage limit")
        ->check (CLI::PositiveNumber);
    command->add_flag ("--quiet", all->isQuiet, "Prints only errors");
    command->callback ([all] { importDevice (*all); });
}
} // namespace antinode
