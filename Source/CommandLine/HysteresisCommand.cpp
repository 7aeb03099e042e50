#include "Commands.h"
#include "FieldOptions.h"
#include "HysteresisFiles.h"

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct HysteresisOptions
{
    DeviceDescription device;
    std::filesystem::path folder = "antinode-hysteresis";
    HysteresisFiles measured;
    bool usesCache = true;
};

Field levelField (const char* option, double& level, const char* what)
{
    return Field (option, &level, what).required().within (1e-6, 1e6);
}
} // namespace

void addHysteresisCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "hysteresis",
        "Measures gain and lag of ceramics at high voltages by responses at two levels; writes the device there");
    auto options = std::make_shared<HysteresisOptions>();
    auto& measured = options->measured;
    const auto read = addFields (
        *command,
        { Field ("device", &options->device, "Device: an embedded name or a .json file").required(),
          Field ("--low", &measured.low,
                 "Frequency responses at a low level, as written by frf and measure (repeatable)")
              .required()
              .written ("FILE"),
          Field ("--high", &measured.high, "The same lines and points at a high level (repeatable)")
              .required()
              .written ("FILE"),
          levelField ("--low-level-v", measured.lowLevel, "Peak voltage of the low level, V"),
          levelField ("--high-level-v", measured.highLevel, "Peak voltage of the high level, V"),
          levelField ("--played-level-v", measured.playedLevel, "Peak voltage of the foci for device.json, V"),
          Field ("--out", &options->folder, "Output folder"), cacheField (options->usesCache) });
    command->callback (
        [options, read]
        {
            read();
            const auto measurement = hysteresisByFiles (options->device, options->measured, options->usesCache);
            writeHysteresis (options->folder, measurement);
            printHysteresis (options->folder.string(), measurement);
        });
}
} // namespace antinode
