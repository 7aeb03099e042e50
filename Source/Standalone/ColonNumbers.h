#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace antinode
{
/** The numbers of "24:-3.5:2", one or more with colons between them; none where something is no finite number. [any] */
std::optional<std::vector<double>> colonNumbers (std::string_view);
} // namespace antinode
