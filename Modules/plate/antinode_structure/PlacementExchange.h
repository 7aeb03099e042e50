#pragma once

#include "PlacementCandidates.h"

#include <functional>
#include <vector>

namespace antinode
{
/** What ceramics cost on their device, less is better; infinite where they are of no use. Any number of threads may ask
   at once. [worker] */
using PlacementCost = std::function<double (const std::vector<CeramicDescription>&)>;

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
} // namespace antinode
