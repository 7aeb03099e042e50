#pragma once

#include "Bench.h"
#include "MeasurementFolder.h"
#include "PointGuide.h"

#include <antinode_measurement/RunAnalysis.h>

namespace antinode
{
/** What the level check plays before the first point: a short multisine in the same band at a tenth of the levels.
    [worker] */
Excitation levelCheckExcitation (const ExcitationSheet&);

/** Measures all points that are not kept yet: checks levels first, leads from point to point, keeps each when it is
   finished.
    @param settings  of the analysis; the latency for benches without a sync channel
    @return          all that is kept and measured; not a number where points were skipped
    @throws InputError  where inputs would clip or receive no signal, the user ends, or the bench cannot play; Cancelled
   where the user interrupts: what is finished is kept [worker] */
SurfaceMeasurement measurePoints (Bench&, const ExcitationSheet&, const Eigen::MatrixX2d& points,
                                  const MeasurementFolder&, const PointGuide&, const RunAnalysisSettings& settings);
} // namespace antinode
