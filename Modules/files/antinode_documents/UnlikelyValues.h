#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** What stands in a device that hardly any has, as a number in another unit than its key says: a
   sentence for each, with the unit that is likely. [any] */
std::vector<std::string> unlikelyValues (const nlohmann::json& document);
} // namespace antinode
