#pragma once

#include "Chart.h"
#include "Report.h"

#include <antinode_sweep/SweepTable.h>

namespace antinode
{
/** The report of a sweep: what varied, distributions, scatter, parallel coordinates, and the extreme cases with the
   command that repeats each. [worker] */
ReportPage sweepReport (const SweepTable&, const SweepSummary&);

/** How often a result has which values. @param column  index among the table's columns [worker] */
LineChart histogram (const SweepTable&, std::size_t column);

/** A result by a key, a dot per case, of some thousand cases at most. @param key  index among sweptKeys [worker] */
LineChart scatter (const SweepTable&, std::size_t key, std::size_t column);

/** Correlations of ranks, a row per key, a column per result. [any] */
HeatMap correlationMap (const SweepSummary&, const std::vector<std::string>& keys);

/** A line per case through its keys and results, of some hundred cases at most. [worker] */
LineChart parallelCoordinates (const SweepTable&);
} // namespace antinode
