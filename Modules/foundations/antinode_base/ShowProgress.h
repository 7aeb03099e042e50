#pragma once

#include <functional>
#include <string>

namespace antinode
{
/** Takes what is being done and the share of it that is done, 0 to 1: a line on a terminal, a bar, nothing. Called
    often; must be quick. */
using ShowProgress = std::function<void (const std::string& what, double share)>;
} // namespace antinode
