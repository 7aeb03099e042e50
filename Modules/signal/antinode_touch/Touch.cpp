#include "Touch.h"

#include <cmath>

namespace antinode
{
std::optional<TouchFault> findFault (const Touch& touch)
{
    if (! std::isfinite (touch.x) || ! std::isfinite (touch.y) || ! std::isfinite (touch.amplitude))
        return TouchFault::notFinite;

    const auto isOutside = [] (double fraction) { return fraction < 0 || fraction > 1; };

    if (! touch.inMillimetres && (isOutside (touch.x) || isOutside (touch.y)))
        return TouchFault::outside;

    return std::nullopt;
}
} // namespace antinode
