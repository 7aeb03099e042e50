#include "MapFiles.h"

#include "FieldNames.h"
#include "FocusOnDevice.h"

#include <antinode_library/Library.h>
#include <antinode_reports/MapReport.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
MappedDevice mapOnDevice (const DeviceDescription& device, const FocusDescription& focus, const MapOptions& options,
                          bool usesCache, const std::function<void (int done, int all)>& show)
{
    checkSampleRate (options.playback.sampleRate);
    auto known = solveDevice (device, {}, usesCache);
    checkKindOfPlaces (known, focus);
    auto map = mapFocus (wideOf (device, known, options.playback, usesCache), focus, options, show);
    return { std::move (map), std::move (known) };
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
