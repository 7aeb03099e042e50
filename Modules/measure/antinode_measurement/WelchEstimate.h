#pragma once

#include "AveragedSpectra.h"

#include <vector>

namespace antinode
{
/** Responses from signals of any kind, by Welch's averages: blocks with a Hann window that overlap by half.

    The variance is that of H1, |H|^2 (1 - gamma^2) / (gamma^2 n), n the number of blocks over 1.06 for the overlap.
   Leakage, which no averaging removes, shows in the coherence.
    @param block  samples, no more than there are
    @param lines  those of a block that are given, ascending
    @param input, outputs  as many samples each; outputs N x samples
    @throws InputError  where there are fewer samples than a block, or the input has nothing on a line
    [worker] Welch, IEEE Trans. Audio Electroacoust. 15, 1967; Bendat and Piersol, Random Data, 2010, section 9.1;
   Docs/Theory.md, section 8.9. */
EstimatedResponses estimateByWelch (Eigen::Index block, const std::vector<Eigen::Index>& lines, ResponseEstimator,
                                    const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs);
} // namespace antinode
