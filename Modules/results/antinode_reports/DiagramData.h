#pragma once

#include "IdentificationReport.h"

#include <nlohmann/json_fwd.hpp>

namespace antinode
{
/** What the script of an identification's diagram draws: poles, candidates, modes with shapes, mode indicator, and what
   the modes leave of each response. Large arrays are base64 (CompactNumbers.h). Resources/Diagram reads it. [worker] */
nlohmann::json diagramData (const IdentificationResult&);
} // namespace antinode
