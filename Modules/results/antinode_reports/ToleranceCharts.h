#pragma once

#include "Chart.h"

#include <antinode_focus/DesignTolerance.h>

#include <vector>

namespace antinode
{
/** Histogram of the field error over the drawn devices, one curve per design.
    @param designs  at least one, each with draws
    [any] */
LineChart toleranceHistogram (const std::vector<DesignTolerance>& designs);

/** Cumulative distribution of the field error over the devices, one curve per design, with the percentiles marked.
    [any] */
LineChart toleranceShares (const std::vector<DesignTolerance>& designs);

/** The largest causes of error: the modes with the largest field errors, each split into frequency, damping and
   participation.
    @param count  how many modes at most
    [any] */
BarChart toleranceCauseChart (const Tolerance&, int count);
} // namespace antinode
