#include "Commands.h"
#include "FolderTask.h"

#include <antinode_tasks/FollowFiles.h>

#include <cstdio>

namespace antinode
{
namespace
{
constexpr double hundred = 100, million = 1e6;

void printDrift (const FollowedDevice& followed, const std::string& folder)
{
    std::printf ("%s\n  %10s %10s %14s %16s\n", followed.nominal.name.c_str(), "time (s)", "state", "common (ppm)",
                 "unexplained (%)");

    for (const auto& moment : followed.trace.moments)
        std::printf ("  %10.2f %10s %14.1f %16.2f  %s\n", moment.time, driftStateWord (moment.state),
                     million * moment.common, hundred * moment.unexplained, moment.reason.c_str());

    std::printf ("The device as it is now: %s/device.json; report: %s/report.html\n", folder.c_str(), folder.c_str());
}
} // namespace

void addFollowCommand (CLI::App& app)
{
    addFolderTask (app, followText, "antinode-drift", &follow, &writeDrift, &printDrift)
        .get_option ("--recorded")
        ->required();
}
} // namespace antinode
