#pragma once

#include "WhitenedAllocation.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Samples of one ceramic's voltage, by index, in the order in which they were limited. */
using SampleList = std::vector<Eigen::Index>;

/** The limits |q_n' x| <= ratio limit of one ceramic in an interior point method, on its working set of samples n:
   slacks and multipliers (column 0 of the upper limit, 1 of the lower) and the Newton system that they give.
   Docs/Theory.md, section 4. */
class CeramicBarrier
{
public:
    /** The residuals of a Newton step. */
    struct Residual
    {
        Eigen::VectorXd share;           ///< Stationarity in the share, N_d.
        Eigen::ArrayX2d slack;           ///< ratio limit -+ voltage - slack.
        Eigen::ArrayX2d complementarity; ///< Wanted change of slack times multiplier, to first order.
    };

    /** A step. */
    struct Direction
    {
        Eigen::VectorXd share;
        Eigen::ArrayX2d slack, multiplier;
    };

    /** @param limitToUse  of the voltage at ratio 1 */
    CeramicBarrier (double limitToUse, Eigen::Index drives);

    /** Those samples that are not yet limited. [worker] */
    SampleList notYetLimited (const SampleList&) const;

    /** Limits more samples; those already limited stay as they are.
        @param fresh       not yet limited
        @param directions  their q_n, N_d x fresh
        @param barrier     product of slack and multiplier of the new ones
        [worker] */
    void add (const SampleList& fresh, const Eigen::MatrixXd& directions, const Eigen::VectorXd& share, double ratio,
              double barrier);

    /** Factors H = curvature I + sum (multiplier / slack) q q'. [worker] N_d^2 working samples */
    void factor (double curvature, const Eigen::MatrixXd& responses);

    /** The right-hand side of H times the change of the share. [worker] */
    Eigen::VectorXd pull (const Residual&) const;

    /** The error of the ratio's multiplier sum due to the residuals. [worker] */
    double ratioPull (const Residual&) const;

    /** The step of slacks and multipliers that belongs to changes of share and ratio. [worker] */
    Direction direction (const Residual&, Eigen::VectorXd share, double ratio) const;

    /** The longest step, at most 1, that keeps slacks and multipliers from becoming negative. [worker] */
    double longestStep (const Direction&) const;

    void advance (const Direction&, double step);

    Eigen::ArrayX2d slackResidual (const Eigen::VectorXd& share, double ratio) const;

    /** Sum over slacks times multipliers, after a step where one is given. [worker] */
    double complementarity() const { return (slacks * multipliers).sum(); }
    double complementarity (const Direction&, double step) const;

    const SampleList& samples() const { return workingSet; }
    const Eigen::ArrayX2d& slack() const { return slacks; }
    const Eigen::ArrayX2d& multiplier() const { return multipliers; }
    Eigen::VectorXd netMultiplier() const { return multipliers.col (0) - multipliers.col (1); }

    /** Limit times the sum of multipliers: what the dual pays for the limits at ratio 1. [worker] */
    double price() const { return limit * multipliers.sum(); }

    /** Sum of q_n times net multiplier, N_d. [worker] */
    Eigen::VectorXd netPull() const { return directions * netMultiplier(); }

    /** L^-1 and L^-T of H = L L'. [worker] */
    Eigen::VectorXd halfSolve (Eigen::VectorXd right) const;
    Eigen::VectorXd otherHalfSolve (Eigen::VectorXd right) const;

    /** Whether H was positive definite, as rounding saw it. [any] */
    bool isFactored() const { return factored; }

    const Eigen::MatrixXd& halfRows() const { return rowsOverL; }   ///< L^-1 responses', N_d x N_r.
    const Eigen::VectorXd& halfRatio() const { return ratioOverL; } ///< L^-1 of the ratio's pull on the share.
    double ratioStiffness() const { return stiffness; }             ///< limit^2 sum multiplier / slack.

private:
    double limit;
    SampleList workingSet;
    Eigen::MatrixXd directions; ///< q_n, N_d x working set.
    Eigen::ArrayX2d slacks, multipliers;
    Eigen::MatrixXd lower; ///< L
    bool factored = false;
    Eigen::MatrixXd rowsOverL;
    Eigen::VectorXd ratioOverL;
    double stiffness = 0;
};

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
