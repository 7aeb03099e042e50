#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_sweep/FocusMap.h>

#include <filesystem>
#include <functional>

namespace antinode
{
/** A map, and the device that it is of. */
struct MappedDevice
{
    FocusMap map;
    ModalModel model;
};

/** A focus at every place of a device.
    @param show  called now and then with how many places are done, by one thread at a time; may be empty
    @throws InputError  as solveDevice and mapFocus
    [worker] Docs/Decisions/0108-maps.md. */
MappedDevice mapOnDevice (const DeviceDescription&, const FocusDescription&, const MapOptions&, bool usesCache,
                          const std::function<void (int done, int all)>& show);

/** Writes map.csv, report.html and summary.json.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeMap (const std::filesystem::path& folder, const MappedDevice&);
} // namespace antinode
