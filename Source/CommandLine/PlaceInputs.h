#pragma once

#include <antinode_structure/Placing.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** What `antinode place --keep-out-mm` takes: "X0,Y0,X1,Y1" in mm. @throws InputError  where it is no rectangle [any]
 */
KeepOut parseKeepOut (const std::string&);

/** The ceramic that is placed, as a document: the first of the device, or a default one.
    @param size  in mm, "20" or "20x10"; empty: its own
    @throws InputError  where it is no size [any] */
nlohmann::json ceramicLike (const nlohmann::json& device, bool isPlate, const std::string& size);

/** A placed ceramic as a document. @param like  what ceramicLike gives [any] */
nlohmann::json ceramicJson (nlohmann::json like, const CeramicDescription&, bool isPlate);

/** The ceramic of a document. @throws InputError  as readDevice, and on a device whose modes are given [any] */
CeramicDescription describedCeramic (nlohmann::json device, const nlohmann::json& ceramic);
} // namespace antinode
