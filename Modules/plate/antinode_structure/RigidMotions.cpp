#include "RigidMotions.h"

#include "EdgeTerms.h"

#include <antinode_numerics/Decompositions.h>

namespace antinode
{
Eigen::MatrixXd freeMotions (const BendingProblem& problem, const ImmersedSpace& space, const BlockBandedMatrix& mass)
{
    constexpr double free = 1e-9; // Of the plate's own stiffness.
    const auto held = symmetricEigen (rigidSupport (problem));
    const auto number = (held.values.array() < free).count();

    if (number == 0)
        return Eigen::MatrixXd (space.unknowns(), 0);

    const auto extent = extentOf (problem.outline);
    const auto size = extent.size().maxCoeff();
    const Eigen::Vector2d middle = (extent.least + extent.largest) / 2;
    Eigen::MatrixXd planes (space.unknowns(), number);

    for (Eigen::Index i = 0; i < number; ++i)
    {
        const Eigen::Vector3d motion = held.vectors.col (i);
        planes.col (i) =
            space.plane (motion[0] - motion.tail<2>().dot (middle) / size, motion[1] / size, motion[2] / size);
    }

    const auto gram = symmetricEigen (planes.transpose() * (mass * planes));
    return planes * gram.vectors * gram.values.cwiseSqrt().cwiseInverse().asDiagonal();
}
} // namespace antinode
