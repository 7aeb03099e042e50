#include "Map.h"

#include "DeviceChecks.h"
#include "Field.h"

#include <antinode_documents/SkinThresholds.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/MapReport.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
std::vector<Field> fields (MapRequest& request)
{
    auto device = deviceOfFocusField (request.device);
    device.option = "device";
    return {
        device,
        focusField (request.focus),
        Field ("--places", &request.places, "Approximate number of places, in square cells").within (1, 100000),
        Field ("--no-felt", &request.hasFelt, "Omits felt levels, which take most of the time").as ("felt"),
        Field ("--threshold", &request.thresholdFile, "Threshold of skin: CSV of Hz and um").by ("the built-in table"),
        sampleRateField (request.sampleRate),
        Field ("--threads", &request.threads, "Places at once").within (1, 1024).by ("one per processor"),
        cacheField (request.usesCache)
    };
}

MappedDevice map (const MapRequest& request, const ShowProgress& show)
{
    if (show)
        show ("Solving the device", 0);

    MapOptions options;
    options.places = request.places;
    options.playback.sampleRate = request.sampleRate;
    options.threads = request.threads ? static_cast<std::size_t> (*request.threads) : processorThreads();

    if (request.hasFelt)
        options.threshold = findSkinThreshold (request.thresholdFile.string());

    auto setup = setUp (request.device, options.playback, request.usesCache);
    checkKindOfPlaces (setup.known, request.focus);
    auto map = mapFocus (setup.wide, request.focus, options,
                         [&] (int done, int all)
                         {
                             if (show)
                                 show ("Mapping", static_cast<double> (done) / all);
                         });
    return { std::move (map), std::move (setup.known) };
}

void writeMap (const std::filesystem::path& path, const MappedDevice& mapped)
{
    OutputFolder folder (path);
    folder.write ("map.csv", mapToCsv (mapped.map, withKeysAndOptions));
    folder.write ("report.html", renderReport (mapReport (mapped.map, mapped.model)));
    folder.write ("summary.json", mapToJson (mapped.map).dump (2) + "\n");
    folder.commit();
}
} // namespace antinode
