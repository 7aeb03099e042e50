#pragma once

#include <Eigen/Core>

namespace antinode
{
/** A step of Gauss and Newton's method. */
struct BoundedStep
{
    Eigen::VectorXd change;   ///< P
    Eigen::MatrixXd factored; ///< P x P: the whole matrix, as factorLower leaves it.
    Eigen::VectorXi held;     ///< P: 1 of those that end at their upper bound, -1 at the lower one, 0 of the others.
};

/** The step x to the minimum of x' M x / 2 - r' x within bounds. A step that is computed without bounds and cut off at
    them may lead up.
    @param matrix  M, P x P, positive definite; of it the lower triangle
    @param right   r, P
    @param lower   P, at most 0: of x; may be infinite, as
    @param upper   P, at least 0
    [worker] Docs/Theory.md, section 7.6, and reference 18. */
BoundedStep boundedStep (const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper);

/** The factor of a step's matrix, P x P, as factorLower leaves it; rows of those that are held are of the unit matrix.
    @param matrix  as in boundedStep
    [worker] */
Eigen::MatrixXd factorOfFree (BoundedStep, Eigen::MatrixXd matrix);
} // namespace antinode
