#include "BendingProblem.h"

#include <cmath>

namespace antinode
{
BendingSection turnedSection (const BendingSection& section, double angle)
{
    // Curvatures along the material's axes from those along x and y; energies are the same in both.
    const auto c = std::cos (angle), s = std::sin (angle);
    Eigen::Matrix3d curvatures;
    curvatures << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
    return { curvatures.transpose() * section.stiffness * curvatures, section.massPerArea, section.rotaryInertia };
}

Eigen::Matrix3d BendingPatch::stiffnessAt (const Eigen::Vector2d& place) const
{
    return bonded ? Eigen::Matrix3d (added.stiffness + bonded->stiffnessAt (place)) : added.stiffness;
}

Eigen::Vector3d BendingPatch::momentAt (const Eigen::Vector2d& place) const
{
    return bonded ? Eigen::Vector3d (moment + bonded->momentAt (place)) : moment;
}

double eigenvalueUnit (const BendingProblem& problem)
{
    return problem.section.stiffness.diagonal().maxCoeff() / problem.section.massPerArea
           / std::pow (extentOf (problem.outline).size().maxCoeff(), 4);
}
} // namespace antinode
