#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** How many modes are solved at most: a beam of more has waves far shorter than thin-beam theory allows; of a plate the
    memory ends it. */
inline constexpr int maximumBeamModes = 200, maximumPlateModes = 500;

/** How many modes of a plate are solved where nothing says how many. */
inline constexpr int defaultPlateModes = 100;

/** @throws InputError  where a plate cannot have so many modes solved [any] */
void requirePlateModes (int count);

/** The one of a device that is solved. [any] */
inline int maximumModes (const DeviceDescription& device)
{
    const auto isPlate =
        std::holds_alternative<PlateDescription> (device.body) || std::holds_alternative<OutlinedPlate> (device.body);
    return isPlate ? maximumPlateModes : maximumBeamModes;
}
} // namespace antinode
