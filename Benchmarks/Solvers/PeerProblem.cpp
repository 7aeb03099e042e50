#include "PeerProblem.h"

#include <antinode_allocation/WhitenedAllocation.h>

namespace antinode::bench
{
PeerProblem::PeerProblem (const AllocationProblem& problem) : whitened (whiten (problem))
{
    const auto drives = whitened.drives();
    rows.resize (whitened.wanted.size(), unknowns());

    for (Eigen::Index i = 0; i < whitened.ceramics(); ++i)
        rows.middleCols (i * drives, drives) = whitened.participation.col (i).asDiagonal() * whitened.responses;
}

PeerQuality assessQuality (const PeerProblem& problem, const Eigen::VectorXd& x)
{
    const Eigen::Map<const Eigen::MatrixXd> shares (x.data(), problem.whitened.drives(), problem.whitened.ceramics());
    const auto& wanted = problem.whitened.wanted;
    return { 0.5 * x.squaredNorm(), (problem.rows * x - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff(),
             problem.whitened.peakRatio (shares) };
}
} // namespace antinode::bench
