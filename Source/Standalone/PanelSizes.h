#pragma once

namespace antinode
{
/** What the panels of settings share, pixels at scale 1. */
inline constexpr int panelRowHeight = 28, panelMargin = 12;
} // namespace antinode
