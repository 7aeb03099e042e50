#include "Commands.h"
#include "CommonOptions.h"
#include "HysteresisFiles.h"

#include <antinode_library/Inputs.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct HysteresisOptions
{
    std::string device, folder = "antinode-hysteresis";
    HysteresisFiles measured;
    bool usesCache = true;
};

void measureHysteresis (const HysteresisOptions& options)
{
    const auto measurement = hysteresisByFiles (loadDevice (options.device, {}), options.measured, options.usesCache);
    writeHysteresis (options.folder, measurement);
    printHysteresis (options.folder, measurement);
}

void addLevel (CLI::App& command, const std::string& name, double& level, const std::string& what)
{
    command.add_option (name, level, what)->required()->check (CLI::Range (1e-6, 1e6))->type_name ("FLOAT");
}
} // namespace

void addHysteresisCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "hysteresis", "Tells by responses at two levels how ceramics answer at high ones, and the device there");
    auto options = std::make_shared<HysteresisOptions>();
    command->add_option ("device", options->device, "Device: an embedded name or a .json file")->required();
    command
        ->add_option ("--low", options->measured.low,
                      "Frequency responses at a low level, as written by frf and measure (repeatable)")
        ->required()
        ->type_name ("FILE")
        ->allow_extra_args (false);
    command->add_option ("--high", options->measured.high, "The same lines and points at a high level (repeatable)")
        ->required()
        ->type_name ("FILE")
        ->allow_extra_args (false);
    addLevel (*command, "--low-level-v", options->measured.lowLevel, "Peak voltage of the low level, V");
    addLevel (*command, "--high-level-v", options->measured.highLevel, "Peak voltage of the high level, V");
    addLevel (*command, "--played-level-v", options->measured.playedLevel,
              "Peak voltage that foci will play, V: what device.json is made for");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    addCacheFlag (*command, options->usesCache);
    command->callback ([options] { measureHysteresis (*options); });
}
} // namespace antinode
