#include "SweepReport.h"

#include "SweepFigures.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_sweep/SweepCases.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t shownColumns = 12, shownScores = 6, shownExtremes = 3, medianIndex = 2;

std::string distributionInWords (const Distribution& distribution)
{
    if (distribution.kind == DistributionKind::uniform)
        return "uniform from " + numberText (distribution.minimum) + " to " + numberText (distribution.maximum);

    auto text = "normal, mean " + numberText (distribution.mean) + ", standard deviation "
                + numberText (distribution.deviation);

    if (std::isfinite (distribution.minimum))
        text += ", at least " + numberText (distribution.minimum);

    if (std::isfinite (distribution.maximum))
        text += ", at most " + numberText (distribution.maximum);

    return text;
}

ReportTable variedTable (const SweepPlan& plan)
{
    ReportTable table { "What varied", { "key", "values" }, {} };

    for (const auto& [key, value] : plan.set)
        table.rows.push_back ({ key, value.dump() + " in all cases" });

    for (const auto& swept : plan.vary)
        for (const auto& key : swept.keys)
            table.rows.push_back ({ key, swept.drawn ? distributionInWords (*swept.drawn)
                                                     : std::to_string (swept.rows.size()) + " listed values" });

    return table;
}

ReportTable resultTable (const SweepSummary& summary)
{
    ReportTable table { "Percentiles over the cases", { "result", "cases", "mean", "standard deviation" }, {} };

    for (const auto percent : tolerancePercents)
        table.header.push_back (fixedText (percent, 0) + " %");

    for (const auto& column : summary.columns)
    {
        table.rows.push_back ({ column.column, std::to_string (column.count) });

        if (column.count == 0)
            continue;

        auto& row = table.rows.back();
        row.push_back (inWords (column.mean));
        row.push_back (inWords (column.deviation));

        for (const auto value : column.percentiles)
            row.push_back (inWords (value));
    }

    return table;
}

/** The cases of least and largest value of each result. */
ReportTable extremeTable (const SweepTable& table)
{
    ReportTable extremes { "Extreme cases", { "result", "case", "value", "repeat with" }, {} };

    for (std::size_t c = 0; c < std::min (table.columns.size(), shownColumns); ++c)
    {
        const auto values = table.values.col (static_cast<Eigen::Index> (c));
        std::vector<Eigen::Index> order;

        for (Eigen::Index i = 0; i < values.size(); ++i)
            if (std::isfinite (values[i]))
                order.push_back (i);

        std::stable_sort (order.begin(), order.end(), [&] (auto a, auto b) { return values[a] < values[b]; });

        for (std::size_t i = 0; i < order.size(); ++i)
            if (i < shownExtremes || i + shownExtremes >= order.size())
                extremes.rows.push_back ({ table.columns[c], std::to_string (order[i]), inWords (values[order[i]]),
                                           "antinode sweep plan.json --case " + std::to_string (order[i]) });
    }

    return extremes;
}

ReportSection distributionSection (const SweepTable& table, const SweepSummary& summary)
{
    ReportSection section;
    section.heading = "Distributions";
    section.tables = { variedTable (table.inputs.plan), resultTable (summary) };

    for (std::size_t c = 0; c < std::min (summary.columns.size(), shownColumns); ++c)
        if (summary.columns[c].count > 1)
            section.figures.push_back ({ "Histogram of " + summary.columns[c].column + ".",
                                         {},
                                         histogram (table, c),
                                         reportFigureWidth,
                                         260 });

    return section;
}

ReportSection dependenceSection (const SweepTable& table, const SweepSummary& summary)
{
    const auto keys = sweptKeys (table.inputs.plan);
    ReportSection section;
    section.heading = "What depends on what";

    if (keys.empty())
        return section;

    section.figures.push_back ({ "Correlation of ranks of each result with each key: 1 and -1 where one rises or falls "
                                 "with the other.",
                                 {},
                                 correlationMap (summary, keys),
                                 reportFigureWidth,
                                 static_cast<int> (120 + 26 * keys.size()) });

    for (std::size_t c = 0; c < std::min (summary.columns.size(), shownColumns); ++c)
        if (const auto& column = summary.columns[c]; column.count > 1)
        {
            const auto strongest = std::max_element (column.correlations.begin(), column.correlations.end(),
                                                     [] (double a, double b) { return std::abs (a) < std::abs (b); });
            const auto key = static_cast<std::size_t> (strongest - column.correlations.begin());
            section.figures.push_back ({ column.column + " by the key that it follows most.",
                                         {},
                                         scatter (table, key, c),
                                         reportFigureWidth,
                                         300 });
        }

    section.figures.push_back (
        { "Parallel coordinates: a line per case through its keys and results, each axis from its "
          "least to its largest value. In the colour of the text: the tenth of the cases "
          "with the lowest first result.",
          {},
          parallelCoordinates (table),
          reportFigureWidth,
          400 });
    return section;
}
} // namespace

ReportPage sweepReport (const SweepTable& table, const SweepSummary& summary)
{
    const auto& plan = table.inputs.plan;
    ReportPage page;
    page.title = (plan.name.empty() ? std::string ("Sweep") : plan.name);
    const auto& played = plan.isOfWaveforms() ? table.inputs.waveforms() : table.inputs.focus();
    page.subtitle = played.value ("name", "") + " on " + table.inputs.device().value ("name", "") + ", "
                    + std::to_string (plan.cases) + " cases, seed " + std::to_string (plan.seed);

    for (const auto& column : summary.columns)
        if (column.count > 0 && page.scores.size() < shownScores)
            page.scores.push_back (
                { column.column, inWords (column.percentiles[medianIndex]), "Median over the cases." });

    if (const auto failed = table.failed(); failed > 0)
        page.warnings.push_back (std::to_string (failed) + " cases failed; results.csv says why.");

    page.sections = { distributionSection (table, summary), dependenceSection (table, summary) };

    ReportSection extremes;
    extremes.heading = "Extreme cases";
    extremes.tables.push_back (extremeTable (table));
    page.sections.push_back (std::move (extremes));
    page.links = { { "results.csv", "results.csv" }, { "plan.json", "plan.json" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}
} // namespace antinode
