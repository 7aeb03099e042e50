#pragma once

#include "Field.h"

#include <antinode_base/Progress.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_sweep/FocusMap.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace antinode
{
inline constexpr TaskText mapText {
    "map", "Designs a focus at every place of a surface: where it is sharp, what it needs, how it is felt",
    "Docs/Design/sweeps.md; Docs/Theory.md, section 6"
};

/** A focus whose first target goes to every place of a device; the others stay as far from it as they are. */
struct MapRequest
{
    FocusDescription focus;
    DeviceDescription device;
    int places = 2000; ///< About so many, in square cells.
    bool hasFelt = true;
    std::filesystem::path thresholdFile; ///< What skin feels; empty: the built-in table.
    double sampleRate = 192000;          ///< Hz
    std::optional<int> threads;          ///< None: one per processor.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (MapRequest&);

/** A map, and the device that it is of. */
struct MappedDevice
{
    FocusMap map;
    ModalModel model;
};

/** A focus at every place of a device.
    @throws InputError  as solveDevice and mapFocus
    [worker] */
MappedDevice map (const MapRequest&, const ShowProgress&);

/** Writes map.csv, report.html and summary.json.
    @throws InputError  when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeMap (const std::filesystem::path& folder, const MappedDevice&);
} // namespace antinode
