#include "BoundedStep.h"

#include <antinode_numerics/DenseKernels.h>

#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
/** Takes an unknown whose change is known out of equations, of which the lower triangle is given. */
void takeOut (Eigen::MatrixXd& matrix, Eigen::VectorXd& right, Eigen::Index p, double change)
{
    const auto after = matrix.rows() - p - 1;
    right.head (p) -= change * matrix.row (p).head (p).transpose();
    right.tail (after) -= change * matrix.col (p).tail (after);
    matrix.row (p).setZero();
    matrix.col (p).setZero();
    matrix (p, p) = 1;
    right[p] = change;
}

/** Which unknowns are at their bounds after a step: 1 at the upper, -1 at the lower one, 0 at neither.
    @param before  those that were held there in this step
    @param slope   downhill, after the step
    @param next    values after it */
Eigen::VectorXi boundsReached (const Eigen::VectorXi& before, const Eigen::VectorXd& slope, const Eigen::VectorXd& next,
                               const Eigen::VectorXd& bounds)
{
    constexpr double rounding = 1e-9;
    Eigen::VectorXi reached (before.size());

    for (Eigen::Index p = 0; p < reached.size(); ++p)
    {
        const auto isPushedOn = before[p] != 0 && before[p] * slope[p] > 0;
        const auto isBeyond = before[p] == 0 && std::abs (next[p]) > bounds[p] + rounding;
        reached[p] = isPushedOn ? before[p] : isBeyond ? (next[p] > 0 ? 1 : -1) : 0;
    }

    return reached;
}
} // namespace

BoundedStep boundedStep (const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Eigen::VectorXd& values,
                         const Eigen::VectorXd& bounds)
{
    constexpr int mostRounds = 8; // Seldom more than three; what is left is cut off.
    Eigen::VectorXi atBound = Eigen::VectorXi::Zero (values.size());

    for (int round = 1;; ++round)
    {
        Eigen::MatrixXd factored = matrix;
        Eigen::VectorXd free = right;

        for (Eigen::Index p = 0; p < values.size(); ++p)
            if (atBound[p] != 0)
                takeOut (factored, free, p, atBound[p] * bounds[p] - values[p]);

        factorLower (factored);
        const Eigen::VectorXd change = solveFactored (factored, free);
        const Eigen::VectorXd slope = right - matrix.selfadjointView<Eigen::Lower>() * change;
        auto reached = boundsReached (atBound, slope, values + change, bounds);

        if (reached == atBound || round == mostRounds)
            return { (values + change).cwiseMax (-bounds).cwiseMin (bounds) - values, std::move (factored) };

        atBound = std::move (reached);
    }
}
} // namespace antinode
