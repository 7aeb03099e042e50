#pragma once

#include "WhitenedAllocation.h"

namespace antinode
{
/** The Gram matrix of the rows, with compliance on its diagonal, factored. N_r x N_r. */
class RowSystem
{
public:
    /** [worker] N_r^2 (N_d + N_b) + N_r^3 / 6 */
    explicit RowSystem (const WhitenedAllocation&);

    /** Multipliers y with rowValues (weightedRows (y)) + compliance y = values. [any] */
    Eigen::VectorXd multipliers (const Eigen::VectorXd& values) const;

    /** L^-1 right, where L L' is the Gram matrix; N_r x any. [worker] */
    Eigen::MatrixXd halfSolve (Eigen::MatrixXd right) const;

    /** The shares of least objective without limits. [worker] */
    Eigen::MatrixXd leastNormShares() const;

    /** Shares with their hard row values brought back to the wanted ones, to rounding, by the smallest change. [worker]
     */
    Eigen::MatrixXd withExactRows (Eigen::MatrixXd shares) const;

private:
    const WhitenedAllocation& problem;
    Eigen::MatrixXd factor;
};
} // namespace antinode
