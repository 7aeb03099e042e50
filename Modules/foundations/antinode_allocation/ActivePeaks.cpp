#include "ActivePeaks.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <utility>

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
} // namespace antinode
