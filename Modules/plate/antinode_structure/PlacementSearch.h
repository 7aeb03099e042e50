#pragma once

#include "PlacementCandidates.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace antinode
{
/** What a choice of candidates, by their indices, costs, less is better; infinite where they are of no use. Any number
   of threads may ask at once. [worker] */
using PlacementCost = std::function<double (const std::vector<Eigen::Index>& chosen)>;

/** Makes a cost of candidates, which outlive it. [worker] */
using PlacementCostOf = std::function<PlacementCost (const PlacementCandidates&)>;

/** Hears of the best choice so far. */
using PlacementNews = std::function<void (const std::vector<CeramicDescription>&)>;

/** The candidates of some indices, named C1, C2 and so on. [any] */
std::vector<CeramicDescription> chosenCeramics (const PlacementCandidates&, const std::vector<Eigen::Index>& chosen);

/** Exchanges chosen candidates for others that overlap them or touch them, as long as the cost falls: each in turn
   gives way to the best in its place. The result does not depend on the number of threads.
    @param chosen    where it begins
    @param news      called from this thread, after each place that was looked at
    @param show      hears of each candidate how far the work is, 0 to 1, from any thread, one at a time
    @return          ascending
    @throws Cancelled  as checkWatch()
    [worker], on all cores. Docs/Design/structure.md, Docs/Design/sweeps.md. */
std::vector<Eigen::Index> exchangeNeighbours (const PlacementCandidates&, std::vector<Eigen::Index> chosen,
                                              const PlacementCost&, const PlacementNews& news = {},
                                              const std::function<void (double)>& show = {});

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
