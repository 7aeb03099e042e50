#pragma once

#include <antinode_allocation/WhitenedAllocation.h>

#include <Eigen/Core>

namespace antinode::bench
{
/** What a general solver is given: the whitened problem, written out, which is the best conditioned form of it.

        minimise 1/2 |x|^2   subject to  rows x = wanted,  -limit <= samples of each ceramic <= limit

    x stacks the shares of the ceramics, N_d each. */
struct PeerProblem
{
    explicit PeerProblem (const AllocationProblem&);

    WhitenedAllocation whitened;
    Eigen::MatrixXd rows; ///< N_k x unknowns.

    int unknowns() const { return static_cast<int> (whitened.drives() * whitened.ceramics()); }
    int samples() const { return static_cast<int> (whitened.basis.rows()); } ///< Of one ceramic.
};

/** What a solver came to. */
struct PeerResult
{
    Eigen::VectorXd x;
    double seconds = 0; ///< Of processor time, with the set-up of its own data.
    bool hasEnded = false;
};

/** How good an answer is, computed from x alone. */
struct PeerQuality
{
    double objective = 0; ///< 1/2 |x|^2
    double rowError = 0;  ///< max |rows x - wanted| / max |wanted|.
    double peakRatio = 0;
};

PeerQuality assessQuality (const PeerProblem&, const Eigen::VectorXd& x);
} // namespace antinode::bench
