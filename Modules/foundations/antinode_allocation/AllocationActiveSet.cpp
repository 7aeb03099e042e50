#include "AllocationActiveSet.h"

#include "LimitedAllocation.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
/** Of a peak's own norm, added to the matrix so that samples which repeat each other share a multiplier; refinement
   takes its effect on the others away. */
constexpr auto softness = 1e-12;

/** Voltages, in parts of the largest limit, which rounding hides in the matrix. */
constexpr auto rounding = 1e-10;

constexpr auto maximumSteps = 20;
} // namespace

ActivePeaks::ActivePeaks (const WhitenedAllocation& problemToUse, const RowSystem& rowsToUse,
                          const Eigen::MatrixXd& startToUse, Eigen::VectorXd limitsToUse)
    : problem (problemToUse), rows (rowsToUse), start (startToUse), limits (std::move (limitsToUse))
{
}

bool ActivePeaks::solve (std::vector<ActivePeak> peaksToLimit, Eigen::VectorXd multipliersToUse)
{
    set (std::move (peaksToLimit), std::move (multipliersToUse));

    for (int n = 0; n < maximumSteps; ++n)
    {
        checkWatch();
        const auto slope = gradient();
        auto part = pushedOrWrong (slope);

        if (part.empty() || slope (part).cwiseAbs().maxCoeff() <= rounding)
            return polish();

        const auto step = risingStep (std::move (part), slope);

        if (! step.allFinite() || ! (slope.dot (step) > 0))
            return false;

        ascend (step, slope);
    }

    return false;
}

void ActivePeaks::set (std::vector<ActivePeak> peaksToLimit, Eigen::VectorXd multipliersToUse)
{
    list = std::move (peaksToLimit);
    z = std::move (multipliersToUse);
    normals.resize (problem.drives(), z.size());

    for (Eigen::Index j = 0; j < z.size(); ++j)
        normals.col (j) = peak (j).sign * problem.direction (peak (j).ceramic, peak (j).sample);

    matrix = gram();
    beyond = excess (start);
}

ActivePeaks::Indices ActivePeaks::pushedOrWrong (const Eigen::VectorXd& slope) const
{
    Indices part;

    for (Eigen::Index j = 0; j < z.size(); ++j)
        if (z[j] > 0 || slope[j] > rounding)
            part.push_back (j);

    return part;
}

Eigen::VectorXd ActivePeaks::newtonStep (const Indices& part, const Eigen::VectorXd& slope) const
{
    Eigen::MatrixXd factors = matrix (part, part);
    Eigen::VectorXd step = slope (part);
    Eigen::VectorXd whole = Eigen::VectorXd::Zero (z.size());

    if (! factorLower (factors))
        return whole;

    solveLower (factors, step);
    solveLowerTransposed (factors, step);
    whole (part) = step;
    return whole;
}

Eigen::VectorXd ActivePeaks::risingStep (Indices part, const Eigen::VectorXd& slope) const
{
    while (true)
    {
        auto step = newtonStep (part, slope);
        const auto isStuck = [&] (Eigen::Index j) { return z[j] == 0 && step[j] < 0; };

        if (std::erase_if (part, isStuck) == 0)
            return step;
    }
}

void ActivePeaks::ascend (const Eigen::VectorXd& step, const Eigen::VectorXd& slope)
{
    constexpr auto minimum = 0.01; // Of the gain that the slope promises.
    const auto straight = (step.array() < 0).select (-z.array() / step.array(), 1.0).minCoeff();

    auto length = 1.0;

    while (length > straight)
    {
        const Eigen::VectorXd next = (z + length * step).cwiseMax (0);
        const Eigen::VectorXd change = next - z;
        const auto promised = slope.dot (change);

        if (promised - 0.5 * change.dot (matrix.selfadjointView<Eigen::Lower>() * change)
            >= minimum * std::abs (promised))
        {
            z = next;
            return;
        }

        length *= 0.5;
    }

    length = std::min (straight, 1.0);

    for (Eigen::Index j = 0; j < z.size(); ++j)
        z[j] = step[j] < 0 && -z[j] >= length * step[j] ? 0.0 : std::max (0.0, z[j] + length * step[j]);
}

bool ActivePeaks::polish()
{
    constexpr auto refinements = 2;
    const auto part = pushedOrWrong (Eigen::VectorXd::Zero (z.size()));

    for (int n = 0; n < refinements; ++n)
        z += newtonStep (part, excess (shares()));

    return z.allFinite();
}

Eigen::MatrixXd ActivePeaks::gram() const
{
    const auto count = normals.cols();
    Eigen::MatrixXd overlaps = Eigen::MatrixXd::Zero (count, count);

    for (Eigen::Index first = 0, end = 0; first < count; first = end)
    {
        while (end < count && peak (end).ceramic == peak (first).ceramic)
            ++end;

        const auto ofCeramic = normals.middleCols (first, end - first);
        addTransposedLeft (overlaps.block (first, first, end - first, end - first), 1, ofCeramic, ofCeramic);
    }

    overlaps.diagonal() *= 1 + softness;
    Eigen::MatrixXd onRows = Eigen::MatrixXd::Zero (problem.wanted.size(), count);
    addProduct (onRows, 1, problem.responses, normals);

    for (Eigen::Index j = 0; j < count; ++j)
        onRows.col (j).array() *= problem.participation.col (peak (j).ceramic).array();

    if (problem.secondResponses.rows() > 0)
    {
        Eigen::MatrixXd second = Eigen::MatrixXd::Zero (problem.wanted.size(), count);
        addProduct (second, 1, problem.secondResponses, normals);

        for (Eigen::Index j = 0; j < count; ++j)
            onRows.col (j).array() +=
                second.col (j).array() * problem.secondParticipation.col (peak (j).ceramic).array();
    }

    const Eigen::MatrixXd taken = rows.halfSolve (std::move (onRows)).transpose();
    addGram (overlaps, -1, taken);
    return overlaps;
}

Eigen::VectorXd ActivePeaks::excess (const Eigen::MatrixXd& shares) const
{
    Eigen::VectorXd all (normals.cols());

    for (Eigen::Index j = 0; j < all.size(); ++j)
        all[j] = normals.col (j).dot (shares.col (peak (j).ceramic)) - limits[peak (j).ceramic];

    return all;
}

Eigen::MatrixXd ActivePeaks::shares() const
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero (problem.drives(), problem.ceramics());

    for (Eigen::Index j = 0; j < z.size(); ++j)
        pull.col (peak (j).ceramic) += z[j] * normals.col (j);

    return rows.withExactRows (start + problem.weightedRows (rows.multipliers (problem.rowValues (pull))) - pull);
}

Eigen::MatrixXd ActivePeaks::sampleMultipliers() const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (problem.basis.rows(), problem.ceramics());

    for (Eigen::Index j = 0; j < z.size(); ++j)
        all (peak (j).sample, peak (j).ceramic) = peak (j).sign * z[j];

    return all;
}

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
