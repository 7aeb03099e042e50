#pragma once

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
} // namespace antinode
