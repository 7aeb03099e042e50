#pragma once

#include <antinode_structure/DeviceDescription.h>

#include <optional>
#include <string>

namespace antinode
{
/** What a device is solved for. */
enum class SolvedShapes
{
    modes,           ///< As solveStructure.
    withStaticShare, ///< As solveWithStaticShare.
    onPointsOfFewer ///< As solveOutlinedOnPointsOfFewer: all that an outlined plate asks for, on the points of so many.
};

/** Everything that the modes of a described device depend on, as bytes: equal where the modes are. None for a device
   that gives its modes itself.

    It holds the name, the body with all its ceramics, the wanted count, what it is solved for,
   the program's version, a fingerprint of the
   sources that solve, and the format of the cache. The description's free text has no part in the modes. [worker] */
std::optional<std::string> modeCacheKey (const DeviceDescription&, std::optional<int> modeCount, SolvedShapes);
} // namespace antinode
