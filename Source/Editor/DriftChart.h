#pragma once

#include <antinode_charts/LineChart.h>
#include <antinode_session/FollowingStatus.h>

namespace antinode
{
/** The common drift of a followed device over time, with twice its deviation to both sides; windows that were not
    explained are gaps. [any] */
LineChart driftChart (const FollowingStatus&);
} // namespace antinode
