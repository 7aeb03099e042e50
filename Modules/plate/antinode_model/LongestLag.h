#pragma once

namespace antinode
{
/** s: by how much a ceramic may act after the first of its device, and the longest low-pass before it; what files may
   say and filters undo. Docs/FileFormats.md. */
inline constexpr double longestLag = 0.01;
} // namespace antinode
