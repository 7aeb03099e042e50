#include "AllocationActiveSet.h"

#include "ActivePeaks.h"
#include "AllocationCertificate.h"
#include "LocalPeaks.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
using Peaks = std::vector<ActivePeak>;

/** New peaks beyond which their matrix costs more than an interior point. */
constexpr Eigen::Index maximumPeaks = 700;

constexpr auto maximumRounds = 30;

/** Of the objective without limits: beyond this they are taken to be out of reach, or nearly so. */
constexpr auto highestBound = 100.0;

/** By how much peaks are held below their limits, so that rounding keeps them within. */
constexpr auto margin = 1e-10;

/** What a limit may be exceeded by. */
constexpr auto tolerance = 1e-9;

bool isBefore (const ActivePeak& a, const ActivePeak& b)
{
    return std::tie (a.ceramic, a.sample) < std::tie (b.ceramic, b.sample);
}

/** A peak with its multiplier. */
using Pushed = std::pair<ActivePeak, double>;

/** The peaks that the limits push. */
std::vector<Pushed> pushed (const ActivePeaks& active)
{
    std::vector<Pushed> kept;
    const auto& z = active.multipliers();

    for (Eigen::Index j = 0; j < z.size(); ++j)
        if (z[j] > 0)
            kept.emplace_back (active.peaks()[static_cast<std::size_t> (j)], z[j]);

    return kept;
}

/** Peaks above the limits that are not among those held, in order. */
Peaks beyond (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& limits, const Peaks& held)
{
    Peaks found;
    const auto lists = localPeaks (voltages, limits);

    for (Eigen::Index i = 0; i < voltages.cols(); ++i)
        for (const auto n : lists[static_cast<std::size_t> (i)])
            if (const ActivePeak peak { i, n, voltages (n, i) > 0 ? 1.0 : -1.0 };
                ! std::binary_search (held.begin(), held.end(), peak, isBefore))
                found.push_back (peak);

    return found;
}

/** Limits the peaks that are pushed and those found. */
bool solveWith (ActivePeaks& active, const Peaks& found)
{
    auto next = pushed (active);

    for (const auto& peak : found)
        next.emplace_back (peak, 0.0);

    std::sort (next.begin(), next.end(), [] (const auto& a, const auto& b) { return isBefore (a.first, b.first); });
    Peaks peaks;
    Eigen::VectorXd multipliers (next.size());

    for (const auto& [peak, multiplier] : next)
    {
        multipliers[static_cast<Eigen::Index> (peaks.size())] = multiplier;
        peaks.push_back (peak);
    }

    return active.solve (std::move (peaks), std::move (multipliers));
}
} // namespace

std::optional<LimitedAllocation> activeSetShares (const WhitenedAllocation& problem, const RowSystem& rows,
                                                  double ratio, const Eigen::MatrixXd& start,
                                                  const ShowAllocationProgress& show)
{
    const Eigen::VectorXd limits = ratio * problem.limits;
    const auto highest = highestBound * problem.objective (start);
    const auto freedom = problem.drives() * problem.ceramics() - problem.hardRows;
    const auto maximum = static_cast<std::size_t> (std::min (maximumPeaks, 2 * freedom));
    ActivePeaks active (problem, rows, start, (1 - margin) * limits);
    LimitedAllocation best;
    best.shares = start;

    while (best.effort.rounds < maximumRounds && best.value < highest)
    {
        report (show, { AllocationStage::activeSet, best.effort.rounds, 1 });
        const auto found = beyond (problem.voltages (best.shares), limits, active.peaks());

        if (found.empty())
        {
            if (problem.peakRatio (best.shares) > (1 + tolerance) * ratio)
                return {};

            best.bound = leastNormBound (problem, rows, active.sampleMultipliers(), ratio);
            return best;
        }

        if (found.size() > maximum || ! solveWith (active, found))
            return {};

        best.shares = active.shares();
        best.value = problem.objective (best.shares);
        ++best.effort.rounds;
    }

    return {};
}
} // namespace antinode
