#include "ModeCacheKey.h"

#include "FieldStream.h"

#include <antinode_structure/DescriptionFields.h>

namespace antinode
{
namespace
{
constexpr int cacheFormat = 4; // To be raised when an entry is written in another way.
}

std::optional<std::string> modeCacheKey (const DeviceDescription& device, std::optional<int> modeCount,
                                         SolvedShapes shapes)
{
    if (! isComputed (device))
        return {};

    FieldWriter writer;
    writer (cacheFormat, std::string (ANTINODE_VERSION), std::string (ANTINODE_SOLVER), device.name, modeCount,
            device.body.index());
    std::visit (
        [&] (const auto& body)
        {
            if constexpr (requires { body.common; })
                writer (body);
        },
        device.body);

    if (shapes == SolvedShapes::withStaticShare)
        writer (std::string ("static share"));

    if (shapes == SolvedShapes::onPointsOfFewer)
        writer (std::string ("points of fewer"));

    return std::move (writer.bytes);
}
} // namespace antinode
