#include "SweepCases.h"

#include "Permutation.h"
#include "Philox.h"
#include "SobolSequence.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/Detuning.h>

#include <algorithm>

namespace antinode
{
namespace
{
/** What random numbers are for, so that none serves twice. A plan has fewer dimensions than lie between two of them. */
enum Stream : std::uint32_t
{
    shareStream = 0,
    strataStream = 1 << 10, // four words a dimension
    shiftStream = 1 << 12
};

std::uint32_t streamOf (Stream stream, std::size_t dimension)
{
    return stream + static_cast<std::uint32_t> (dimension);
}

/** Sobol's point moved by the seed's own shift, bit by bit, to the middle of its cell: never 0 or 1. */
double shiftedSobol (const SweepPlan& plan, std::uint64_t point, std::size_t dimension)
{
    constexpr int halfWord = 32;
    const auto shift =
        static_cast<std::uint32_t> (randomBits (plan.seed, 0, streamOf (shiftStream, dimension)) >> halfWord);
    const auto bits = sobolPoint (static_cast<std::uint32_t> (point), static_cast<int> (dimension)) ^ shift;
    return (static_cast<double> (bits) + 0.5) * 0x1p-32;
}

/** Of the rows of one point: the first matrix, the second, then the first with one column of the second. */
double saltelliShare (const SweepPlan& plan, std::uint64_t number, std::size_t dimension)
{
    const auto dimensions = plan.vary.size();
    const auto block = number % (dimensions + 2);
    const auto isSecond = block == 1 || block == dimension + 2;
    return shiftedSobol (plan, number / (dimensions + 2), dimension + (isSecond ? dimensions : 0));
}

double stratifiedShare (const SweepPlan& plan, std::uint64_t number, std::size_t dimension)
{
    const auto stratum =
        permuted (number, plan.cases, plan.seed, strataStream / 4 + static_cast<std::uint32_t> (dimension));
    const auto within = randomUniform (plan.seed, number, streamOf (shareStream, dimension));
    return std::min ((static_cast<double> (stratum) + within) / static_cast<double> (plan.cases), 1 - 0x1p-53);
}

/** The middle of the case's row among those of a dimension of a grid. */
double gridShare (const SweepPlan& plan, std::uint64_t number, std::size_t dimension)
{
    for (auto d = plan.vary.size(); --d > dimension;)
        number /= plan.vary[d].rows.size();

    const auto count = plan.vary[dimension].rows.size();
    return (static_cast<double> (number % count) + 0.5) / static_cast<double> (count);
}

double shareOf (const SweepPlan& plan, std::uint64_t number, std::size_t dimension)
{
    switch (plan.scheme)
    {
        case SweepScheme::grid:
            return gridShare (plan, number, dimension);
        case SweepScheme::latinHypercube:
            return stratifiedShare (plan, number, dimension);
        case SweepScheme::sobol:
            return shiftedSobol (plan, number, dimension);
        case SweepScheme::saltelli:
            return saltelliShare (plan, number, dimension);
        case SweepScheme::random:
            break;
    }

    return randomUniform (plan.seed, number, streamOf (shareStream, dimension));
}
} // namespace

std::vector<std::string> sweptKeys (const SweepPlan& plan)
{
    std::vector<std::string> keys;

    for (const auto& swept : plan.vary)
        keys.insert (keys.end(), swept.keys.begin(), swept.keys.end());

    return keys;
}

std::vector<std::string> sweepColumns (const SweepPlan& plan)
{
    auto columns = plan.record;

    for (const auto& [x, y] : plan.points)
        columns.push_back ("field_mm_s_at_" + numberText (x * milli) + "_" + numberText (y * milli));

    return columns;
}

std::vector<double> caseShares (const SweepPlan& plan, std::uint64_t number)
{
    std::vector<double> shares;

    for (std::size_t d = 0; d < plan.vary.size(); ++d)
        shares.push_back (shareOf (plan, number, d));

    return shares;
}

std::vector<nlohmann::json> caseValues (const SweepPlan& plan, std::uint64_t number)
{
    std::vector<nlohmann::json> values;
    const auto shares = caseShares (plan, number);

    for (std::size_t d = 0; d < plan.vary.size(); ++d)
    {
        const auto& swept = plan.vary[d];

        if (swept.drawn)
        {
            const auto drawn = quantile (*swept.drawn, shares[d]);

            for (std::size_t k = 0; k < swept.keys.size(); ++k)
                values.emplace_back (swept.plus[k] + swept.times[k] * drawn);

            continue;
        }

        const auto count = static_cast<double> (swept.rows.size());
        const auto row = std::min (static_cast<std::size_t> (shares[d] * count), swept.rows.size() - 1);
        values.insert (values.end(), swept.rows[row].begin(), swept.rows[row].end());
    }

    return values;
}

std::vector<std::pair<std::string, nlohmann::json>> caseAssignments (const SweepPlan& plan, std::uint64_t number)
{
    auto assignments = plan.set;
    const auto keys = sweptKeys (plan);
    auto values = caseValues (plan, number);

    for (std::size_t i = 0; i < keys.size(); ++i)
        assignments.emplace_back (keys[i], std::move (values[i]));

    return assignments;
}

std::uint64_t deviationSeed (const SweepPlan& plan, std::uint64_t number)
{
    return drawSeed (plan.seed, number);
}
} // namespace antinode
