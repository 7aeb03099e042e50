#pragma once

#include "Chart.h"

#include <antinode_focus/DesignTolerance.h>

#include <vector>

namespace antinode
{
/** How many of the devices drawn have which field error: a histogram, a curve a design.
    @param designs  at least one, each with draws
    [any] */
LineChart toleranceHistogram (const std::vector<DesignTolerance>& designs);

/** The share of devices on which the field error is at most so large, a curve a design, the percentiles marked on it. [any] */
LineChart toleranceShares (const std::vector<DesignTolerance>& designs);

/** What hurts most: the modes of the largest field errors, each with those of its frequency, damping and participations.
    @param count  how many modes at most
    [any] */
BarChart toleranceCauseChart (const Tolerance&, int count);
} // namespace antinode
