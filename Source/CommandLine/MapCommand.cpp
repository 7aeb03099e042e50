#include "Commands.h"
#include "CommonOptions.h"
#include "MapFiles.h"
#include "Progress.h"

#include <antinode_library/Inputs.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
struct MapCommandOptions
{
    std::string device, focus = "demonstrator", folder = "antinode-out", thresholdFile;
    std::vector<std::string> assignments;
    double rate = 192000; // Hz
    int places = 2000, threads = 0;
    bool hasFelt = true, usesCache = true, isQuiet = false;
};

void printMap (const FocusMap& map, const MapCommandOptions& options)
{
    const auto print =
        [&] (const char* name, const char* unit, const std::function<std::optional<double> (const MapPlace&)>& value)
    {
        std::vector<double> values;

        for (const auto& place : map.places)
            if (const auto found = place.error.empty() ? value (place) : std::nullopt)
                values.push_back (*found);

        if (values.empty())
            return;

        std::sort (values.begin(), values.end());
        std::printf ("  %-14s %10.4g %10.4g %10.4g %s\n", name, values.front(), values[values.size() / 2],
                     values.back(), unit);
    };
    std::printf ("%s on %s: %td x %td places\n  %-14s %10s %10s %10s\n", map.focus.c_str(), map.device.c_str(),
                 map.columns, map.rows, "", "least", "median", "largest");
    print ("captured", "", [] (const MapPlace& place) { return place.captured; });
    print ("v-score", "", [] (const MapPlace& place) { return place.vScore; });
    print ("peak voltage", "V", [] (const MapPlace& place) { return place.peakVoltage; });
    print ("felt contrast", "dB", [] (const MapPlace& place) { return place.contrast; });

    const auto failed =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); });

    if (failed > 0)
        std::printf ("  %td places cannot be designed for; map.csv says why\n", failed);

    std::printf ("Maps: %s/report.html\n", options.folder.c_str());
}

void map (const MapCommandOptions& options)
{
    checkAssignments (options.assignments);
    const auto focus = loadFocus (options.focus, options.assignments);
    const auto description =
        loadDevice (deviceFor (LibraryKind::focus, { options.focus }, options.device, usualDevice, options.assignments),
                    options.assignments);
    MapOptions settings;
    settings.places = options.places;
    settings.playback.sampleRate = options.rate;
    settings.threads = options.threads > 0 ? static_cast<std::size_t> (options.threads) : processorThreads();

    if (options.hasFelt)
        settings.threshold = findSkinThreshold (options.thresholdFile);

    Progress progress (options.isQuiet);
    progress.show ("Solving the device", 0);
    const auto mapped =
        mapOnDevice (description, focus, settings, options.usesCache,
                     [&] (int done, int all)
                     {
                         progress.show ("Mapping", static_cast<double> (done) / all,
                                        std::to_string (done) + " of " + std::to_string (all) + " places");
                     });
    writeMap (options.folder, mapped);

    if (! options.isQuiet)
        printMap (mapped.map, options);
}
} // namespace

void addMapCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "map", "Designs a focus at every place of a surface: where it is sharp, what it needs, how it is felt");
    auto options = std::make_shared<MapCommandOptions>();
    command->add_option ("device", options->device,
                         "Device: an embedded name or a .json file (default: the one that the focus names)");
    command->add_option ("focus", options->focus, "Focus: an embedded name or a .json file")->capture_default_str();
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    command->add_option ("--places", options->places, "About how many places, in square cells")
        ->check (CLI::Range (1, 100000))
        ->capture_default_str();
    command->add_option ("--rate", options->rate, "Sample rate, Hz")->type_name ("FLOAT")->capture_default_str();
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example focus.targets.0.width_mm=30 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--threshold", options->thresholdFile,
                         "CSV of Hz and um: what skin feels, in place of the built-in table");
    command->add_flag ("!--no-felt", options->hasFelt, "Leaves out what skin feels, which takes most of the time");
    command->add_option ("--threads", options->threads, "Places at once; default: one per processor")
        ->check (CLI::Range (1, 1024))
        ->type_name ("INT");
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { map (*options); });
}
} // namespace antinode
