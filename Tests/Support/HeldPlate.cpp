#include "Support/HeldPlate.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace antinode::test
{
Eigen::MatrixXd exponential (const Eigen::MatrixXd& a)
{
    const auto norm = a.cwiseAbs().rowwise().sum().maxCoeff();
    const auto halvings = std::max (0, static_cast<int> (std::ceil (std::log2 (norm / 0.1))));
    const Eigen::MatrixXd small = a / std::pow (2.0, halvings);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Identity (a.rows(), a.cols()), term = sum;

    for (int i = 1; i < 16; ++i)
    {
        term = (term * small / i).eval();
        sum += term;
    }

    for (int i = 0; i < halvings; ++i)
        sum = (sum * sum).eval();

    return sum;
}

HeldPlate::HeldPlate (const ModalModel& bare, const std::vector<Finger>& fingers, double interval)
    : count (bare.modes())
{
    const Eigen::VectorXd omega = bare.angularFrequencies;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Identity (count, count);
    Eigen::MatrixXd damping = (2 * bare.dampingRatios.cwiseProduct (omega)).asDiagonal();
    Eigen::MatrixXd stiffness = omega.cwiseAbs2().asDiagonal();

    for (const auto& finger : fingers)
    {
        const Eigen::VectorXd under = contactShapes (bare, finger).transpose();
        mass += finger.mass * under * under.transpose();
        damping += finger.damping * under * under.transpose();
        stiffness += finger.stiffness * under * under.transpose();
    }

    // Scaled so that displacements are as large as velocities.
    const auto scale = omega.mean();
    const auto solver = mass.partialPivLu();
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero (3 * count, 3 * count);
    whole.block (0, count, count, count) = scale * Eigen::MatrixXd::Identity (count, count);
    whole.block (count, 0, count, count) = -solver.solve (stiffness) / scale;
    whole.block (count, count, count, count) = -solver.solve (damping);
    whole.block (count, 2 * count, count, count) = solver.inverse();
    step = exponential (whole * interval);
    state = Eigen::VectorXd::Zero (2 * count);
}

Eigen::VectorXd HeldPlate::after (const Eigen::VectorXd& force)
{
    state = (step.topLeftCorner (2 * count, 2 * count) * state + step.topRightCorner (2 * count, count) * force).eval();
    return state.tail (count);
}
} // namespace antinode::test
