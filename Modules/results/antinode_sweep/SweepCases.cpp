#include "SweepCases.h"

#include "Distribution.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/Detuning.h>

#include <algorithm>

namespace antinode
{
namespace
{
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
    return plan.scheme == SweepScheme::grid ? gridShare (plan, number, dimension)
                                            : randomUniform (plan.seed, number, static_cast<std::uint32_t> (dimension));
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
