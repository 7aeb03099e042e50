#include "PlacementExchange.h"

#include <antinode_numerics/EvaluatedCases.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
class NeighbourExchange
{
public:
    NeighbourExchange (const PlacementCandidates& candidatesToUse, const PlacementCost& costToUse,
                       std::vector<Eigen::Index> chosenToBegin)
        : candidates (candidatesToUse), cost (costToUse), chosen (std::move (chosenToBegin)),
          least (cost (chosenCeramics (candidates, chosen)))
    {
    }

    /** @param show  hears of the share of the place's candidates
        @return  whether the place has another candidate now */
    bool improve (std::size_t place, const std::function<void (double)>& show)
    {
        constexpr double worthwhile = 1 - 1e-6;
        const auto neighbours = freeNeighbours (place);
        const std::function<double (std::size_t)> costOf = [&] (std::size_t i)
        {
            auto others = chosen;
            others[place] = neighbours[i];
            return cost (chosenCeramics (candidates, others));
        };
        const auto costs =
            evaluateCases (neighbours.size(), costOf,
                           [&] (std::uint64_t done)
                           {
                               if (show)
                                   show (static_cast<double> (done) / static_cast<double> (neighbours.size()));
                           });
        const auto best = std::min_element (costs.begin(), costs.end());

        if (best == costs.end() || ! (*best < worthwhile * least))
            return false;

        least = *best;
        chosen[place] = neighbours[static_cast<std::size_t> (best - costs.begin())];
        return true;
    }

    const std::vector<Eigen::Index>& result() const { return chosen; }

private:
    bool isNeighbour (Eigen::Index a, Eigen::Index b) const
    {
        const auto& first = candidates.ceramics[static_cast<std::size_t> (a)];
        const auto& second = candidates.ceramics[static_cast<std::size_t> (b)];
        constexpr double touching = 1 + 1e-6;
        return std::abs (first.x - second.x) <= touching * first.sizeX
               && std::abs (first.y - second.y) <= touching * first.sizeY;
    }

    std::vector<Eigen::Index> freeNeighbours (std::size_t place) const
    {
        std::vector<Eigen::Index> free;

        for (Eigen::Index candidate = 0; candidate < candidates.participation.cols(); ++candidate)
        {
            auto isFree = isNeighbour (chosen[place], candidate);

            for (std::size_t i = 0; i < chosen.size() && isFree; ++i)
                isFree = chosen[i] != candidate && (i == place || ! candidates.overlap (chosen[i], candidate));

            if (isFree)
                free.push_back (candidate);
        }

        return free;
    }

    const PlacementCandidates& candidates;
    const PlacementCost& cost;
    std::vector<Eigen::Index> chosen;
    double least;
};
} // namespace

std::vector<CeramicDescription> chosenCeramics (const PlacementCandidates& candidates,
                                                const std::vector<Eigen::Index>& chosen)
{
    std::vector<CeramicDescription> ceramics;

    for (const auto index : chosen)
    {
        ceramics.push_back (candidates.ceramics[static_cast<std::size_t> (index)]);
        ceramics.back().name = "C" + std::to_string (ceramics.size());
    }

    return ceramics;
}

std::vector<Eigen::Index> exchangeNeighbours (const PlacementCandidates& candidates, std::vector<Eigen::Index> chosen,
                                              const PlacementCost& cost, const PlacementNews& news,
                                              const std::function<void (double)>& show)
{
    constexpr double expectedRounds = 3;
    const auto places = chosen.size();
    NeighbourExchange exchange (candidates, cost, std::move (chosen));
    double done = 0;
    const auto turn = 1 / (expectedRounds * static_cast<double> (places));
    const auto showTurn = [&] (double share)
    {
        if (show)
            show (std::min (done + turn * share, 1.0));
    };

    // It ends: each exchange costs less than the last, and there are only so many choices.
    for (std::size_t place = 0, unchanged = 0; unchanged < places; place = (place + 1) % places)
    {
        unchanged = exchange.improve (place, showTurn) ? 0 : unchanged + 1;
        done += turn;

        if (news)
            news (chosenCeramics (candidates, exchange.result()));
    }

    auto result = exchange.result();
    std::sort (result.begin(), result.end());
    return result;
}
} // namespace antinode
