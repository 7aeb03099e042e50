#pragma once

#include <string>
#include <vector>

namespace antinode
{
/** Names in the order of the numbers at their ends where all begin alike, P2 before P10; else as they are. [any] */
std::vector<std::string> inNaturalOrder (std::vector<std::string> names);
} // namespace antinode
