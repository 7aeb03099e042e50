#pragma once

#include <Eigen/Core>

#include <functional>

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

/** What the most probable values of P unknowns minimise: the squared residuals over their noise, and the squared
   unknowns, which are in standard deviations of what was known of them before. */
struct SumOfSquares
{
    /** The sum near some values, to the second order. */
    struct Equations
    {
        Eigen::MatrixXd matrix; ///< P x P, positive definite; of it the lower triangle.
        Eigen::VectorXd right;  ///< P: downhill.
        double sum = 0;
    };

    std::function<Equations (const Eigen::VectorXd&)> equations;
    std::function<double (const Eigen::VectorXd&)> sum;
};

struct GaussNewtonSettings
{
    int mostSteps = 12;
    double leastGain = 0.05; ///< Of the sum, with
    double leastShare = 0;   ///< times the sum: a step that gains less is the last.
    Eigen::VectorXd bounds;  ///< P: that no unknown leaves, either way; may be infinite.
    Eigen::VectorXd
        stepLimits; ///< P: how far the first step may go; later ones up to eight times as far. May be infinite.
    std::function<bool (int steps, double sum)>
        isHopeless; ///< Where it says so after so many steps, they were the last.
};

/** Where an iteration ended. */
struct SmallestSum
{
    Eigen::VectorXd values;   ///< P
    Eigen::MatrixXd factored; ///< P x P: of the last step, as factorOfFree.
    double sum = 0;
};

/** Gauss and Newton's method within bounds, with shorter steps where a step leads up.
    @param start  P, within the bounds
    @throws       what the functions throw
    [worker] Docs/Theory.md, section 7.6. */
SmallestSum smallestSum (const SumOfSquares&, Eigen::VectorXd start, const GaussNewtonSettings&);
} // namespace antinode
