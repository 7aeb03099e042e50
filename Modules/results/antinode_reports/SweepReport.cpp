#include "SweepReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_sweep/SweepCases.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    const auto devices = plan.variedDevices().size();
    page.subtitle =
        played.value ("name", "") + " on "
        + (devices == 0 ? table.inputs.device ({}).value ("name", "") : std::to_string (devices) + " devices") + ", "
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

namespace
{
constexpr auto gap = std::numeric_limits<double>::quiet_NaN();

/** Every so many-th, so that at most so many are left. */
std::vector<Eigen::Index> someCases (Eigen::Index cases, Eigen::Index most)
{
    std::vector<Eigen::Index> some;

    for (Eigen::Index i = 0; i < std::min (cases, most); ++i)
        some.push_back (cases <= most ? i : i * cases / most);

    return some;
}

/** From 0 to 1 between the least and the largest that there are. */
Eigen::VectorXd normalised (const Eigen::VectorXd& values)
{
    double least = std::numeric_limits<double>::infinity(), largest = -least;

    for (const auto value : values)
        if (std::isfinite (value))
        {
            least = std::min (least, value);
            largest = std::max (largest, value);
        }

    if (! (largest > least))
        return values.unaryExpr ([] (double value) { return std::isfinite (value) ? 0.5 : gap; });

    return (values.array() - least) / (largest - least);
}

/** The last part of a key, which fits below an axis. */
std::string shortName (const std::string& key)
{
    constexpr std::size_t longest = 18;
    const auto dot = key.rfind ('.');
    const auto name = dot == std::string::npos ? key : key.substr (dot + 1);
    return name.size() > longest ? name.substr (0, longest - 1) + "…" : name;
}
} // namespace

LineChart histogram (const SweepTable& table, std::size_t column)
{
    constexpr int bins = 40;
    const Eigen::VectorXd values = table.values.col (static_cast<Eigen::Index> (column));
    std::vector<double> some;
    std::copy_if (values.begin(), values.end(), std::back_inserter (some), [] (double v) { return std::isfinite (v); });
    const auto [least, largest] = std::minmax_element (some.begin(), some.end());
    const auto from = *least, width = std::max (*largest - from, std::abs (from) * 1e-9 + 1e-300) / bins;
    Series series;
    series.name = table.columns[column];
    series.filled = true;
    series.x = Eigen::VectorXd::Zero (2 * bins + 2);
    series.y = Eigen::VectorXd::Zero (2 * bins + 2);

    for (const auto value : some)
    {
        const auto bin = std::clamp (static_cast<int> ((value - from) / width), 0, bins - 1);
        series.y[2 * bin + 1] += 1;
        series.y[2 * bin + 2] += 1;
    }

    for (int edge = 0; edge <= bins; ++edge)
        series.x.segment<2> (2 * edge).setConstant (from + edge * width);

    LineChart chart;
    chart.xLabel = table.columns[column];
    chart.yLabel = "cases";
    chart.series = { std::move (series) };
    chart.legend = LegendPlace::none;
    return chart;
}

LineChart scatter (const SweepTable& table, std::size_t key, std::size_t column)
{
    constexpr Eigen::Index most = 2000;
    const auto x = sweptNumbers (table, key);
    const auto some = someCases (table.cases(), most);
    Series series;
    series.name = table.columns[column];
    series.points = true;
    series.x = Eigen::VectorXd::Constant (static_cast<Eigen::Index> (2 * some.size()), gap);
    series.y = series.x;

    for (std::size_t i = 0; i < some.size(); ++i)
    {
        series.x[static_cast<Eigen::Index> (2 * i)] = x[some[i]];
        series.y[static_cast<Eigen::Index> (2 * i)] = table.values (some[i], static_cast<Eigen::Index> (column));
    }

    LineChart chart;
    chart.xLabel = sweptKeys (table.inputs.plan)[key];
    chart.yLabel = table.columns[column];
    chart.series = { std::move (series) };
    chart.legend = LegendPlace::none;
    return chart;
}

HeatMap correlationMap (const SweepSummary& summary, const std::vector<std::string>& keys)
{
    HeatMap chart;
    chart.values = Eigen::MatrixXd::Constant (static_cast<Eigen::Index> (keys.size()),
                                              static_cast<Eigen::Index> (summary.columns.size()), gap);

    for (std::size_t c = 0; c < summary.columns.size(); ++c)
    {
        chart.columnNames.push_back (shortName (summary.columns[c].column));
        const auto& correlations = summary.columns[c].correlations;

        for (std::size_t k = 0; k < correlations.size(); ++k)
            chart.values (static_cast<Eigen::Index> (k), static_cast<Eigen::Index> (c)) = correlations[k];
    }

    for (const auto& key : keys)
        chart.rowNames.push_back (shortName (key));

    chart.valueLabel = "correlation of ranks";
    chart.scale = ColourScale::diverging;
    chart.valueRange = AxisRange { -1, 1 };
    chart.x = { 0, static_cast<double> (summary.columns.size()) };
    chart.y = { 0, static_cast<double> (keys.size()) };
    return chart;
}

LineChart parallelCoordinates (const SweepTable& table)
{
    constexpr Eigen::Index most = 150, mostAxes = 12;
    const auto keys = sweptKeys (table.inputs.plan);
    std::vector<Eigen::VectorXd> axes;
    LineChart chart;

    const auto addAxis = [&] (const std::string& name, const Eigen::VectorXd& values)
    {
        if (static_cast<Eigen::Index> (axes.size()) == mostAxes)
            return;

        chart.markers.push_back ({ static_cast<double> (axes.size()), shortName (name) });
        axes.push_back (normalised (values));
    };

    for (std::size_t k = 0; k < keys.size(); ++k)
        addAxis (keys[k], sweptNumbers (table, k));

    const auto first = axes.size();

    for (std::size_t c = 0; c < table.columns.size(); ++c)
        addAxis (table.columns[c], table.values.col (static_cast<Eigen::Index> (c)));

    const auto some = someCases (table.cases(), most);
    std::vector<double> firstResults;

    for (const auto i : some)
        if (first < axes.size() && std::isfinite (axes[first][i]))
            firstResults.push_back (axes[first][i]);

    std::sort (firstResults.begin(), firstResults.end());
    const auto best = firstResults.empty() ? -1 : firstResults[firstResults.size() / 10];
    const auto stride = static_cast<Eigen::Index> (axes.size()) + 1;
    const auto lines = [&] (const std::string& name, bool isBest, int colour)
    {
        Series series;
        series.name = name;
        series.colour = colour;
        series.x = Eigen::VectorXd::Constant (stride * static_cast<Eigen::Index> (some.size()), gap);
        series.y = series.x;

        for (std::size_t i = 0; i < some.size(); ++i)
            if ((first < axes.size() && axes[first][some[i]] <= best) == isBest)
                for (std::size_t a = 0; a < axes.size(); ++a)
                {
                    const auto at = stride * static_cast<Eigen::Index> (i) + static_cast<Eigen::Index> (a);
                    series.x[at] = static_cast<double> (a);
                    series.y[at] = axes[a][some[i]];
                }

        return series;
    };
    chart.series = { lines ("other cases", false, 0),
                     lines ("lowest tenth of the first result", true, series_colour::neutral) };
    chart.xLabel = "keys, then results";
    chart.yLabel = "least to largest";
    chart.xRange = AxisRange { 0, std::max (1.0, static_cast<double> (axes.size()) - 1) };
    chart.yRange = AxisRange { 0, 1 };
    return chart;
}
} // namespace antinode
