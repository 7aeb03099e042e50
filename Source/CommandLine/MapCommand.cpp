#include "Commands.h"
#include "FolderTask.h"

#include <antinode_tasks/Map.h>

#include <algorithm>
#include <cstdio>
#include <functional>

namespace antinode
{
namespace
{
void printMap (const MappedDevice& mapped, const std::string& folder)
{
    const auto& map = mapped.map;
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

    std::printf ("Maps: %s/report.html\n", folder.c_str());
}
} // namespace

void addMapCommand (CLI::App& app)
{
    addFolderTask (app, mapText, "antinode-out", &map, &writeMap, &printMap);
}
} // namespace antinode
