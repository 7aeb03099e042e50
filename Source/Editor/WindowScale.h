#pragma once

namespace antinode
{
/** What a content needs, pixels at scale 1. */
struct ContentSizes
{
    int leastWidth = 0, leastHeight = 0; ///< All is reachable from here on.
    int roomyWidth = 0, roomyHeight = 0; ///< It grows with its window from here on.
};

/** By how much a content is drawn larger in a window: as wanted, as far as all of it stays reachable.
    @param wanted  0: as large as suits the window [any] */
double windowScale (int width, int height, const ContentSizes&, double wanted);
} // namespace antinode
