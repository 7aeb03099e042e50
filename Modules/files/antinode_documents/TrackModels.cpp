#include "TrackModels.h"

#include "Library.h"

#include <antinode_structure/ModeLimits.h>
#include <antinode_structure/StaticShare.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace antinode
{
namespace
{
/** Half as many modes again as the design knows, where the device is solved; a measured one has no more. */
std::optional<int> judgedModes (const DeviceDescription& description, const ModalModel& known)
{
    if (! isComputed (description))
        return {};

    const auto modes = known.modes() - (hasStaticShare (description) ? known.actuators() : 0);
    return std::min (maximumModes (description), static_cast<int> (3 * modes / 2));
}
} // namespace

TrackModels trackModels (const DeviceDescription& device, bool usesCache)
{
    auto known = solveDeviceWithStaticShare (device, {}, usesCache);
    auto judge = solveDeviceWithStaticShare (device, judgedModes (device, known), usesCache);
    return { std::move (known), std::move (judge) };
}
} // namespace antinode
