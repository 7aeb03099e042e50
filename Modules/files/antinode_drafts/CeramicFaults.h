#pragma once

#include "CeramicEdits.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** What is wrong with the place of a ceramic while it is drawn. */
struct CeramicFault
{
    std::size_t ceramic = 0;
    bool isForbidden = true; ///< Else the device can be played, but hardly anyone glues a ceramic so.
    std::string sentence;    ///< "C3 overlaps C2"
};

/** Ceramics outside the device, on others, or closer to an edge than they can be glued.
    @throws InputError  where the device has no valid outline [worker] */
std::vector<CeramicFault> ceramicFaults (const nlohmann::json& device);
} // namespace antinode
