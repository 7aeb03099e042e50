#pragma once

#include "CeramicBarrier.h"
#include "WhitenedAllocation.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Primal-dual interior point (Mehrotra's predictor and corrector) on those samples of the voltages that matter:

        minimise    curvature (1/2 |X|^2 + guards' part), or ratio where it is free
        subject to  hard rows,  |Q x_i| <= ratio limits (i)  on the working set of samples

    With a free ratio this gives the least peak: there the curvature pulls each step to where it starts, not to 0, so
   that it steadies the steps and leaves the optimum alone. With a fixed ratio and curvature 1 it gives the least norm.
   A step costs N_d^2 x working samples + N_b N_r^2 N_d + N_r^3 / 6. Docs/Theory.md, section 4.
*/
class AllocationInteriorPoint
{
public:
    enum class Ratio
    {
        fixed,
        free
    };

    /** @param shares  where to start: they meet the hard rows
        @param ratio   where to start, or the fixed one
        [worker] */
    AllocationInteriorPoint (const WhitenedAllocation&, Ratio, double ratio, double curvature, Eigen::MatrixXd shares);

    /** Limits more samples: one list per ceramic. [worker] */
    void addSamples (const std::vector<SampleList>&);

    /** One step towards the optimum of the working set.
        @return  false where rounding leaves nothing to step along
        [worker] */
    bool step();

    const Eigen::MatrixXd& shares() const { return x; }
    double peakRatio() const { return ratio; }
    const Eigen::VectorXd& rowMultipliers() const { return y; }
    std::vector<SampleList> samples() const;

    /** Upper less lower multipliers, N_s x N_b, 0 outside the working set. [worker] */
    Eigen::MatrixXd sampleMultipliers() const;

private:
    using Residuals = std::vector<CeramicBarrier::Residual>;

    struct Direction
    {
        std::vector<CeramicBarrier::Direction> ceramics;
        Eigen::VectorXd rows;
        double ratio = 0;
    };

    double firstProduct (const std::vector<SampleList>&) const;
    double products() const;
    double complementarity() const;
    double complementarity (const Direction&, double step) const;
    double longestStep (const Direction&) const;
    bool factor();
    Eigen::VectorXd rowSolve (Eigen::VectorXd right) const;
    Residuals residuals() const;
    Direction solve (const Residuals&) const;
    void advance (const Direction&, double step);

    const WhitenedAllocation& problem;
    Ratio kind;
    double ratio, curvature;
    Eigen::MatrixXd x; ///< N_d x N_b
    Eigen::VectorXd y; ///< N_r
    std::vector<CeramicBarrier> ceramics;
    Eigen::MatrixXd rowSystem; ///< Factored.
    Eigen::VectorXd ratioOnRows, ratioMultipliers;
    double ratioStiffness = 0;
};
} // namespace antinode
