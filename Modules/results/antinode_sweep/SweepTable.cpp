#include "SweepTable.h"

#include "SweepCases.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/MatlabWriter.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <set>

namespace antinode
{
namespace
{
constexpr int allDigits = 17;

std::string cellOf (const nlohmann::json& value)
{
    return csvField (value.is_string() ? value.get<std::string>() : value.dump());
}

/** Of the values that a key is given in the plan, which one this is, from 1. */
double rowOf (const SweepPlan& plan, std::size_t key, const nlohmann::json& value)
{
    for (const auto& swept : plan.vary)
    {
        if (key >= swept.keys.size())
        {
            key -= swept.keys.size();
            continue;
        }

        const auto found =
            std::find_if (swept.rows.begin(), swept.rows.end(), [&] (const auto& row) { return row[key] == value; });
        return static_cast<double> (found - swept.rows.begin() + 1);
    }

    return 0;
}

/** What MATLAB takes for a name that is not taken yet: letters, digits and '_', a letter first, 63 at most. */
std::string matlabName (const std::string& key, std::set<std::string>& taken)
{
    constexpr std::size_t longest = 58;
    auto name = key.substr (key.size() > longest ? key.size() - longest : 0);
    std::replace_if (
        name.begin(), name.end(), [] (unsigned char c) { return std::isalnum (c) == 0; }, '_');

    if (name.empty() || std::isalpha (static_cast<unsigned char> (name.front())) == 0)
        name = "x" + name;

    auto unique = name;

    for (int i = 2; ! taken.insert (unique).second; ++i)
        unique = name + "_" + std::to_string (i);

    return unique;
}
} // namespace

std::size_t SweepTable::failed() const
{
    return static_cast<std::size_t> (
        std::count_if (errors.begin(), errors.end(), [] (const auto& error) { return ! error.empty(); }));
}

SweepTable mergeParts (const PartFolder& folder, const SweepInputs& inputs)
{
    const auto lacking = folder.missing ({}).size();

    if (lacking > 0)
        throw InputError ("sweep", std::to_string (lacking) + " of " + std::to_string (folder.parts().size())
                                       + " parts are missing; run it or its shards again, which computes them alone");

    SweepTable table { inputs, sweepColumns (inputs.plan), {}, {} };
    table.values.resize (static_cast<Eigen::Index> (inputs.plan.cases),
                         static_cast<Eigen::Index> (table.columns.size()));
    Eigen::Index row = 0;

    for (std::size_t part = 0; part < folder.parts().size(); ++part)
    {
        checkWatch();

        for (const auto& result : folder.read (part))
        {
            if (result.values.size() != table.columns.size())
                throw InputError ("part " + std::to_string (part), "has other columns than the plan");

            table.values.row (row++) = Eigen::Map<const Eigen::RowVectorXd> (result.values.data(), table.values.cols());
            table.errors.push_back (result.error);
        }
    }

    return table;
}

std::string sweepToCsv (const SweepTable& table, const std::function<std::string (std::string)>& inWords)
{
    const auto& plan = table.inputs.plan;
    std::string text = "case";

    for (const auto& key : sweptKeys (plan))
        text += "," + csvField (key);

    for (const auto& column : table.columns)
        text += "," + csvField (column);

    text += ",error\n";

    for (Eigen::Index i = 0; i < table.cases(); ++i)
    {
        checkWatch();
        text += std::to_string (i);

        for (const auto& value : caseValues (plan, static_cast<std::uint64_t> (i)))
            text += "," + cellOf (value);

        for (const auto value : table.values.row (i))
        {
            text += ',';

            if (std::isfinite (value))
                appendCsvNumber (text, value, allDigits);
        }

        const auto& error = table.errors[static_cast<std::size_t> (i)];
        text += "," + (error.empty() ? "" : csvField (inWords (error))) + "\n";
    }

    return text;
}

Eigen::VectorXd sweptNumbers (const SweepTable& table, std::size_t key)
{
    Eigen::VectorXd numbers (table.cases());

    for (Eigen::Index i = 0; i < numbers.size(); ++i)
    {
        const auto value = caseValues (table.inputs.plan, static_cast<std::uint64_t> (i))[key];
        numbers[i] = value.is_number() ? value.get<double>() : rowOf (table.inputs.plan, key, value);
    }

    return numbers;
}

std::string sweepToMatlab (const SweepTable& table)
{
    std::set<std::string> taken { "cases" };
    const auto last = static_cast<double> (table.cases() - 1);
    std::vector<MatlabMatrix> matrices { { "cases", Eigen::VectorXd::LinSpaced (table.cases(), 0, last), {} } };
    const auto keys = sweptKeys (table.inputs.plan);

    for (std::size_t k = 0; k < keys.size(); ++k)
        matrices.push_back ({ matlabName (keys[k], taken), sweptNumbers (table, k), {} });

    for (std::size_t c = 0; c < table.columns.size(); ++c)
        matrices.push_back (
            { matlabName (table.columns[c], taken), table.values.col (static_cast<Eigen::Index> (c)), {}, true });

    return encodeMatlabFile (matrices);
}

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
