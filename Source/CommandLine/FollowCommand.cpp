#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_tasks/FollowFiles.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
constexpr double hundred = 100, million = 1e6;

struct FollowOptions
{
    FollowRequest request;
    std::filesystem::path folder = "antinode-drift";
    bool isQuiet = false;
};

void print (const FollowedDevice& followed, const std::string& folder)
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
    auto* command = app.add_subcommand (followText.name, followText.summary);
    auto options = std::make_shared<FollowOptions>();
    auto all = fields (options->request);
    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet) });
    const auto read = addFields (*command, all);
    command->get_option ("--recorded")->required();
    command->callback (
        [options, read]
        {
            read();

            if (options->request.recorded.empty())
                throw InputError ("--recorded", "is empty; allowed: a folder with voltages.wav and what was recorded");

            Progress progress (options->isQuiet);
            const auto followed = follow (options->request, progress.shown());
            writeDrift (options->folder, followed);

            if (! options->isQuiet)
                print (followed, options->folder.string());
        });
}
} // namespace antinode
