#pragma once

#include "Excitation.h"

namespace antinode
{
/** The latency of a recording of the sync channel in samples, to 0.01 samples or better: the lag of the largest
    correlation, then the slope of the cross-spectrum's phase, every line weighted by its power and its frequency's
   square.
    @param sync  a run's recording of the sync channel, any gain or sign but 0
    @return      samples, at least 0
    @throws InputError  where the excitation is not in it, or so late that its end is missing
    [worker] Docs/Theory.md, section 8.9. */
double estimateLatency (const Excitation&, const Eigen::VectorXd& sync);
} // namespace antinode
