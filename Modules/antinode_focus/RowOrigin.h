#pragma once

#include "DriveAllocation.h"

namespace antinode
{
/** What the rows of an allocation problem stand for. */
struct RowOrigin
{
    std::vector<int> controlled, guards; ///< Modes.
    DriveList drives;
    double time = 0; ///< s from the trigger: that of the focus.
    Playback playback;
};
} // namespace antinode
