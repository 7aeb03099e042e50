#include "PlacementSearch.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace antinode
{
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
