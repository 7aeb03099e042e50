#include "RowSystem.h"

#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
RowSystem::RowSystem (const WhitenedAllocation& problemToUse) : problem (problemToUse)
{
    factor = problem.rowGram();
    factor.diagonal() += problem.compliance;
    factorLower (factor);
}

Eigen::VectorXd RowSystem::multipliers (const Eigen::VectorXd& values) const
{
    return solveFactored (factor, values);
}

Eigen::MatrixXd RowSystem::halfSolve (Eigen::MatrixXd right) const
{
    solveLower (factor, right);
    return right;
}

Eigen::MatrixXd RowSystem::leastNormShares() const
{
    return withExactRows (problem.weightedRows (multipliers (problem.wanted)));
}

Eigen::MatrixXd RowSystem::withExactRows (Eigen::MatrixXd shares) const
{
    constexpr auto refinements = 2;

    for (int i = 0; i < refinements; ++i)
    {
        Eigen::VectorXd change = Eigen::VectorXd::Zero (problem.wanted.size());
        change.head (problem.hardRows) =
            solveFactored (problem.hardFactor, (problem.wanted - problem.rowValues (shares)).head (problem.hardRows));
        shares += problem.weightedRows (change);
    }

    return shares;
}
} // namespace antinode
