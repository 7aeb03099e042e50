#include "PlacementSearch.h"

#include <antinode_model/InputError.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <thread>

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
        : problem (problemToUse), progress (progressToUse),
          sum (Eigen::MatrixXd::Zero (problem.kernel.rows(), problem.kernel.cols()))
    {
    }

    Placement run()
    {
        Placement placement;

        while (static_cast<Eigen::Index> (placement.chosen.size()) < problem.count)
        {
            const auto best = bestBeside (placement.chosen, -1);

            if (best.index < 0)
                throw InputError ("--count", "is " + std::to_string (problem.count) + ", but beside "
                                                 + std::to_string (placement.chosen.size())
                                                 + " ceramics there is no room for another: allowed are fewer, or "
                                                   "smaller ones");

            placement.chosen.push_back (best.index);
            placement.controllability = best.value;
            add (best.index, 1);
            report (placement.chosen.size());
        }

        exchange (placement);
        std::sort (placement.chosen.begin(), placement.chosen.end());
        return placement;
    }

private:
    void exchange (Placement& placement)
    {
        constexpr int mostRounds = 20;
        constexpr double worthwhile = 1 + 1e-9;
        auto isBetter = true;

        for (int round = 0; round < mostRounds && isBetter; ++round)
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
                report (placement.chosen.size());
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

    /** The best candidate that may stand beside the others, or none where none exceeds a value. */
    Candidate bestBeside (const std::vector<Eigen::Index>& others, double toExceed)
    {
        const auto threads = std::max (1U, std::thread::hardware_concurrency());
        std::vector<Candidate> best (threads);
        std::vector<std::thread> workers;

        for (unsigned thread = 0; thread < threads; ++thread)
            workers.emplace_back (
                [&, thread] { best[thread] = bestOfShare (others, toExceed, thread, static_cast<int> (threads)); });

        for (auto& worker : workers)
            worker.join();

        return *std::max_element (best.begin(), best.end(),
                                  [] (const Candidate& a, const Candidate& b)
                                  { return a.value != b.value ? a.value < b.value : a.index > b.index; });
    }

    Candidate bestOfShare (const std::vector<Eigen::Index>& others, double toExceed, Eigen::Index first, int step) const
    {
        Candidate best { -1, toExceed };

        for (auto candidate = first; candidate < problem.participation.cols(); candidate += step)
        {
            const auto isFree = std::none_of (others.begin(), others.end(),
                                              [&] (Eigen::Index other)
                                              { return other == candidate || problem.exclude (other, candidate); });

            if (isFree)
                consider (best, candidate);
        }

        return best.index < 0 ? Candidate {} : best;
    }

    /** A Cholesky factorisation tells whether a candidate is better; only then its value is computed. */
    void consider (Candidate& best, Eigen::Index candidate) const
    {
        auto gramian = gramianWith (candidate);

        if (best.value > 0)
        {
            Eigen::MatrixXd shifted = gramian;
            shifted.diagonal().array() -= best.value;

            if (Eigen::LLT<Eigen::MatrixXd> (shifted).info() != Eigen::Success)
                return;
        }

        const auto value =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> (gramian, Eigen::EigenvaluesOnly).eigenvalues()[0];

        if (value > best.value)
            best = { candidate, value };
    }

    void report (std::size_t chosen)
    {
        // How many rounds there will be is not known: every step comes a little nearer to the end.
        ++steps;
        const auto expected = 4.0 * static_cast<double> (problem.count);

        if (progress && chosen > 0)
            progress (steps / (steps + expected) * 1.25 < 1 ? steps / (steps + expected) * 1.25 : 0.99);
    }

    const PlacementProblem& problem;
    const std::function<void (double)>& progress;
    Eigen::MatrixXd sum;
    double steps = 0;
};
} // namespace

Placement searchPlacement (const PlacementProblem& problem, const std::function<void (double)>& progress)
{
    return Search (problem, progress).run();
}
} // namespace antinode
