#pragma once

#include "DriveAllocation.h"

namespace antinode
{
/** The meaning of the rows of an allocation problem. */
struct RowOrigin
{
    std::vector<int> controlled, guards; ///< Modes.
    DriveList drives;
    double time = 0; ///< s from the trigger: that of the focus.
    Playback playback;
};
} // namespace antinode
