#include "SweepSummary.h"

#include "SweepCases.h"

#include <antinode_base/NumberText.h>
#include <antinode_focus/Tolerance.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
std::vector<double> present (const Eigen::VectorXd& values)
{
    std::vector<double> some;
    std::copy_if (values.begin(), values.end(), std::back_inserter (some), [] (double v) { return std::isfinite (v); });
    return some;
}

ColumnSummary columnSummary (const SweepTable& table, Eigen::Index column, const std::vector<Eigen::VectorXd>& varied)
{
    const Eigen::VectorXd values = table.values.col (column);
    const auto some = present (values);
    ColumnSummary summary;
    summary.column = table.columns[static_cast<std::size_t> (column)];
    summary.count = static_cast<Eigen::Index> (some.size());

    if (some.empty())
        return summary;

    const Eigen::Map<const Eigen::VectorXd> all (some.data(), summary.count);
    summary.mean = all.mean();
    summary.deviation =
        summary.count > 1
            ? std::sqrt ((all.array() - summary.mean).square().sum() / static_cast<double> (summary.count - 1))
            : 0;
    summary.minimum = all.minCoeff();
    summary.maximum = all.maxCoeff();
    summary.percentiles = computePercentiles (some);

    for (const auto& numbers : varied)
        summary.correlations.push_back (rankCorrelation (numbers, values));

    return summary;
}

nlohmann::ordered_json columnJson (const ColumnSummary& column, const SweepPlan& plan)
{
    nlohmann::ordered_json json { { "cases", column.count } };

    if (column.count == 0)
        return json;

    json["mean"] = column.mean;
    json["standard_deviation"] = column.deviation;
    json["minimum"] = column.minimum;
    json["maximum"] = column.maximum;

    for (std::size_t i = 0; i < tolerancePercents.size(); ++i)
        json["percentile_" + fixedText (tolerancePercents[i], 0)] = column.percentiles[i];

    const auto keys = sweptKeys (plan);

    for (std::size_t k = 0; k < keys.size(); ++k)
        json["rank_correlation"][keys[k]] = column.correlations[k];

    return json;
}
/** Ranks from 1, equal values sharing the mean of theirs. */
Eigen::VectorXd ranksOf (const Eigen::VectorXd& values)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (values.size()));
    std::iota (order.begin(), order.end(), 0);
    std::sort (order.begin(), order.end(), [&] (auto a, auto b) { return values[a] < values[b]; });
    Eigen::VectorXd ranks (values.size());

    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end)
    {
        while (end < order.size() && values[order[end]] == values[order[begin]])
            ++end;

        for (auto i = begin; i < end; ++i)
            ranks[order[i]] = 0.5 * static_cast<double> (begin + end + 1);
    }

    return ranks;
}
} // namespace

double rankCorrelation (const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    std::vector<Eigen::Index> both;

    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (std::isfinite (a[i]) && std::isfinite (b[i]))
            both.push_back (i);

    if (both.size() < 2)
        return 0;

    Eigen::VectorXd left = ranksOf (a (both)), right = ranksOf (b (both));
    left.array() -= left.mean();
    right.array() -= right.mean();
    const auto scale = left.norm() * right.norm();
    return scale > 0 ? left.dot (right) / scale : 0;
}

SweepSummary summarise (const SweepTable& table)
{
    std::vector<Eigen::VectorXd> varied;

    for (std::size_t k = 0; k < sweptKeys (table.inputs.plan).size(); ++k)
        varied.push_back (sweptNumbers (table, k));

    SweepSummary summary;

    for (Eigen::Index c = 0; c < table.values.cols(); ++c)
        summary.columns.push_back (columnSummary (table, c, varied));

    return summary;
}

nlohmann::ordered_json sweepToJson (const SweepTable& table, const SweepSummary& summary)
{
    const auto& plan = table.inputs.plan;
    nlohmann::ordered_json json;
    json["sweep"] = plan.name;
    json["plan_hash"] = table.inputs.hash;
    json["cases"] = plan.cases;
    json["failed"] = table.failed();

    for (const auto& column : summary.columns)
        json["results"][column.column] = columnJson (column, plan);

    return json;
}

std::string sweepInWords (const SweepTable& table, const SweepSummary& summary)
{
    auto text = formatted ("%-30s", "percentile");

    for (const auto percent : tolerancePercents)
        text += formatted (" %11.0f", percent);

    text += "\n";

    for (const auto& column : summary.columns)
    {
        text += formatted ("%-30s", column.column.c_str());

        if (column.count > 0)
            for (const auto value : column.percentiles)
                text += " " + formatted ("%11s", inWords (value).c_str());

        text += "\n";
    }

    if (const auto failed = table.failed(); failed > 0)
        text += std::to_string (failed) + " of " + std::to_string (table.inputs.plan.cases)
                + " cases failed; results.csv says why\n";

    return text;
}
} // namespace antinode
