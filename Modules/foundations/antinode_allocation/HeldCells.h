#pragma once

#include "LowerBound.h"
#include "MinimumPeak.h"

#include <vector>

namespace antinode
{
/** Voltages that are held from edge to edge, each ceramic's edges its own, and the velocities that they bring: over a
   cell integral h_k = g_k (end) - g_k (start) with g_k (tau) = e^{-a tau} sin (b tau) / b. [worker] */
class HeldCells
{
public:
    /** 6 cells a cycle of the fastest mode that is not yet decayed by 60 dB, at least 32, fewer than 1 GiB of weights.
     */
    explicit HeldCells (const WaveformBoundProblem&);

    /** The rows of one volt-limit: participation times limit times integral. */
    MinimumPeakProblem problem() const;

    /** Splits cells in which sum_k y_k participation_ki h_k changes its sign, so that what they lose stays below a part
       of the price; hands the samples on.
        @return  false where nothing is to be gained or memory is full */
    bool split (MinimumPeak&, double part);

    std::vector<HeldWaveform> waveforms (const Eigen::VectorXd& samples) const;

private:
    struct Ceramic
    {
        Eigen::VectorXd edges, gains;
        std::shared_ptr<const Eigen::MatrixXd> weights;
    };

    Eigen::MatrixXd computeWeights (const Eigen::VectorXd& edges) const;

    Eigen::VectorXcd poles;
    Eigen::VectorXd wanted;
    std::vector<Ceramic> ceramics;
};
} // namespace antinode
