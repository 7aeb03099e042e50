#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace antinode
{
/** Some of many candidates, so that the worst controllability is largest. */
struct PlacementProblem
{
    Eigen::MatrixXd kernel;        ///< N_m x N_m, scaled: controllabilities are relative to 1.
    Eigen::MatrixXd participation; ///< N_m x candidates, scaled in the same way.
    Eigen::Index count = 0;        ///< The number of candidates to choose, at least 1.
    std::function<bool (Eigen::Index, Eigen::Index)> exclude; ///< Whether two candidates cannot both be chosen. [any]
};

struct Placement
{
    std::vector<Eigen::Index> chosen; ///< Ascending.
    double controllability = 0;       ///< The least eigenvalue of the Gramian.
    int exchanges = 0;                ///< The number of exchanges for better candidates.
};

/** Greedy choice, one candidate after the other, then exchanges: every chosen one in turn gives way to the best in its
   place, until a round brings no more; the best of six such runs that begin with different candidates. The result
   depends on the problem only, whatever the number of threads.
    @param progress  called with 0 to 1, from this thread; never decreasing
    @throws InputError  when there is no room for so many
    [worker], on all cores. Docs/Theory.md, section 1.9. */
Placement searchPlacement (const PlacementProblem&, const std::function<void (double)>& progress = {});
} // namespace antinode
