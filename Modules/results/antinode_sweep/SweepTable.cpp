#include "SweepTable.h"

#include "SweepCases.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/MatlabWriter.h>

#include <algorithm>
#include <cctype>
#include <cmath>
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
} // namespace antinode
