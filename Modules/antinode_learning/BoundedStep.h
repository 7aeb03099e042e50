#pragma once

#include <Eigen/Core>

namespace antinode
{
/** A step of Gauss and Newton's method. */
struct BoundedStep
{
    Eigen::VectorXd change;   ///< P
    Eigen::MatrixXd factored; ///< P x P: the matrix, those at bounds taken out, as factorLower leaves it.
};

/** The step x to the minimum of x' M x / 2 - r' x that takes no value beyond its bounds. A step that is
    computed without bounds and cut off at them may lead up.
    @param matrix  M, P x P, positive definite; of it the lower triangle
    @param right   r, P
    @param values  P: of the unknowns now, within the bounds
    @param bounds  P, above 0: of the magnitudes of the values
    [worker] Docs/Theory.md, section 7.6, and reference 18. */
BoundedStep boundedStep (const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Eigen::VectorXd& values,
                         const Eigen::VectorXd& bounds);
} // namespace antinode
