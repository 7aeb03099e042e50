#include "PlacementSearch.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace antinode
{
namespace
{
class NeighbourExchange
{
public:
    NeighbourExchange (const PlacementCandidates& candidatesToUse, const PlacementCost& costToUse,
                       std::vector<Eigen::Index> chosenToBegin)
        : candidates (candidatesToUse), cost (costToUse), chosen (std::move (chosenToBegin)), least (cost (chosen))
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
            return cost (others);
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

namespace
{
struct Candidate
{
    Eigen::Index index = -1;
    double value = -1;
};

class Search
{
public:
    Search (const PlacementProblem& problemToUse, const std::function<void (double)>& progressToUse)
        : problem (problemToUse), progress (progressToUse)
    {
    }

    /** The best of several runs, each of which begins with another candidate. */
    Placement run()
    {
        Placement best;
        std::vector<Eigen::Index> begun;

        for (start = 0; start < starts; ++start)
        {
            sum = Eigen::MatrixXd::Zero (problem.kernel.rows(), problem.kernel.cols());
            const auto first = bestBeside (begun, -1, true);

            if (first.index < 0)
                break;

            begun.push_back (first.index);
            auto placement = greedyFrom (first);
            exchange (placement);

            if (best.chosen.empty() || placement.controllability > best.controllability)
                best = placement;

            report (start + 1);
        }

        std::sort (best.chosen.begin(), best.chosen.end());
        return best;
    }

private:
    static constexpr int starts = 6;

    Placement greedyFrom (const Candidate& first)
    {
        Placement placement { { first.index }, first.value, 0 };
        add (first.index, 1);

        while (static_cast<Eigen::Index> (placement.chosen.size()) < problem.count)
        {
            const auto next = bestBeside (placement.chosen, -1);

            if (next.index < 0)
                throw InputError ("placement: number of ceramics", "is " + std::to_string (problem.count)
                                                                       + "; there is no room for another after "
                                                                       + std::to_string (placement.chosen.size())
                                                                       + " ceramics; choose fewer or smaller ceramics");

            placement.chosen.push_back (next.index);
            placement.controllability = next.value;
            add (next.index, 1);
            report (start + 0.5 * static_cast<double> (placement.chosen.size()) / static_cast<double> (problem.count));
        }

        return placement;
    }

    void exchange (Placement& placement)
    {
        constexpr double worthwhile = 1 + 1e-9;
        auto isBetter = true;

        // It ends: each exchange is better than the last, and there are only so many choices.
        while (isBetter)
        {
            isBetter = false;

            for (auto& place : placement.chosen)
            {
                auto others = placement.chosen;
                std::erase (others, place);
                add (place, -1);
                const auto best = bestBeside (others, placement.controllability * worthwhile);

                if (best.index >= 0)
                {
                    place = best.index;
                    placement.controllability = best.value;
                    ++placement.exchanges;
                    isBetter = true;
                }

                add (place, 1);
            }
        }
    }

    /** The Gramian is the kernel times this sum of alpha alpha', entry by entry. */
    void add (Eigen::Index candidate, double sign)
    {
        const Eigen::VectorXd column = problem.participation.col (candidate);
        sum += sign * column * column.transpose();
    }

    Eigen::MatrixXd gramianWith (Eigen::Index candidate) const
    {
        const auto column = problem.participation.col (candidate);
        return problem.kernel.cwiseProduct (sum + column * column.transpose());
    }

    /** The best candidate that does not overlap the others, or none if none exceeds a value. */
    Candidate bestBeside (const std::vector<Eigen::Index>& others, double toExceed, bool mayOverlap = false) const
    {
        std::vector<Candidate> best (processorThreads());
        parallelFor (best.size(),
                     [&] (std::size_t share)
                     {
                         best[share] = bestOfShare (others, toExceed, mayOverlap, static_cast<Eigen::Index> (share),
                                                    static_cast<Eigen::Index> (best.size()));
                     });

        return *std::max_element (best.begin(), best.end(),
                                  [] (const Candidate& a, const Candidate& b)
                                  { return a.value != b.value ? a.value < b.value : a.index > b.index; });
    }

    Candidate bestOfShare (const std::vector<Eigen::Index>& others, double toExceed, bool mayOverlap,
                           Eigen::Index first, Eigen::Index step) const
    {
        Candidate best { -1, toExceed };

        for (auto candidate = first; candidate < problem.participation.cols(); candidate += step)
        {
            const auto isFree =
                std::none_of (others.begin(), others.end(),
                              [&] (Eigen::Index other)
                              { return other == candidate || (! mayOverlap && problem.exclude (other, candidate)); });

            if (isFree)
                consider (best, candidate);
        }

        return best.index < 0 ? Candidate {} : best;
    }

    /** A Cholesky factorisation shows whether a candidate is better; only then its value is computed. */
    void consider (Candidate& best, Eigen::Index candidate) const
    {
        auto gramian = gramianWith (candidate);

        if (best.value > 0)
        {
            Eigen::MatrixXd shifted = gramian;
            shifted.diagonal().array() -= best.value;

            if (! factorLower (shifted))
                return;
        }

        const auto value = symmetricEigenvalues (gramian)[0];

        if (value > best.value)
            best = { candidate, value };
    }

    void report (double startsDone) const
    {
        if (progress)
            progress (startsDone / starts);
    }

    const PlacementProblem& problem;
    const std::function<void (double)>& progress;
    Eigen::MatrixXd sum;
    int start = 0;
};
} // namespace

Placement searchPlacement (const PlacementProblem& problem, const std::function<void (double)>& progress)
{
    return Search (problem, progress).run();
}
} // namespace antinode
