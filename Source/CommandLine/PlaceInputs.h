#pragma once

#include <antinode_structure/Placing.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The options of `antinode place`. */
struct PlaceOptions
{
    std::string device = "aluminium-200x120";
    int count = 8;
    std::string size;                                   // mm, "L" or "LxW"
    std::optional<double> step, edgeDistance, duration; // mm, mm, ms
    double freeEdge = 2;                                // mm
    int modes = 40;
    std::string file;
    std::vector<std::string> assignments, focuses, keepOut;
    std::vector<int> counts;
    bool isFrozen = false, isQuiet = false;
};

/** How places are searched. @param ceramic  the one that is placed
    @throws InputError  as parseKeepOut [any] */
PlacingOptions placingOptions (const PlaceOptions&, const CeramicDescription& ceramic);

/** What `antinode place --keep-out-mm` takes: "X0,Y0,X1,Y1" in mm. @throws InputError  where it is no rectangle [any]
 */
KeepOut parseKeepOut (const std::string&);

/** The ceramic that is placed, as a document: the first of the device, or a default one.
    @param size  in mm, "20" or "20x10"; empty: its own
    @throws InputError  where it is no size [any] */
nlohmann::json ceramicLike (const nlohmann::json& device, bool isPlate, const std::string& size);

/** The device with placed ceramics, named so, as a document. @param like  what ceramicLike gives [any] */
nlohmann::json placedDevice (nlohmann::json device, const nlohmann::json& like, const std::vector<CeramicDescription>&);

/** The ceramic of a document. @throws InputError  as readDevice, and on a device whose modes are given [any] */
CeramicDescription describedCeramic (nlohmann::json device, const nlohmann::json& ceramic);
} // namespace antinode
