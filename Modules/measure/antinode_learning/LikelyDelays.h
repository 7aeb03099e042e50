#pragma once

#include "PlayedRecording.h"

#include <vector>

namespace antinode
{
/** The delays at which a recording correlates most with what a model predicts, the most likely one first: maxima of at
    least a quarter of the largest, between the samples by a parabola. All lie between the recording's delay and its
   delaySpan beyond; at least one.
    @param predicted  samples x N: as the sensors would hear it without delay
    @param most       how many at most
    @return           s
    [worker] Docs/Theory.md, section 7.6. */
std::vector<double> likelyDelays (const PlayedRecording&, const Eigen::MatrixXd& predicted, std::size_t most);
} // namespace antinode
