#pragma once

#include "Report.h"

#include <antinode_sweep/SweepSummary.h>

namespace antinode
{
/** The report of a sweep: what varied, distributions, scatter, parallel coordinates, and the extreme cases with the
   command that repeats each. [worker] */
ReportPage sweepReport (const SweepTable&, const SweepSummary&);
} // namespace antinode
