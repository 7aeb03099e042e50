#include "WindowScale.h"

#include <algorithm>

namespace antinode
{
double windowScale (int width, int height, const ContentSizes& sizes, double wanted)
{
    const auto most =
        std::min (static_cast<double> (width) / sizes.leastWidth, static_cast<double> (height) / sizes.leastHeight);
    const auto suitable = std::max (1.0, std::min (static_cast<double> (width) / sizes.roomyWidth,
                                                   static_cast<double> (height) / sizes.roomyHeight));
    return std::min (most, wanted > 0 ? wanted : suitable);
}
} // namespace antinode
