#pragma once

#include "Chart.h"
#include "Report.h"

#include <antinode_focus/Tolerance.h>

#include <vector>

namespace antinode
{
/** The report on devices that differ from the model: scores, histogram, percentiles, largest causes of error. The last
   design is the one reported on, the others are shown for comparison.
    @param focus  its name
    [worker] */
ReportPage toleranceReport (const ModalModel&, const std::string& focus, const std::vector<DesignTolerance>&);

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
