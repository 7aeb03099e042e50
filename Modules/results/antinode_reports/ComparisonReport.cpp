#include "ComparisonReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace antinode
{
namespace
{
std::string numberOrNone (double number)
{
    return std::isfinite (number) ? inWords (number) : "-";
}

std::string levelsInWords (const ComparedCase& compared)
{
    std::string text;

    for (const auto level : compared.levels)
        text += (text.empty() ? "" : ", ") + fixedText (level, 1);

    return compared.missing < 0 ? text + " (" + fixedText (compared.missing, 1) + " dB by the limits)" : text;
}

/** Each once, in the order in which they come. */
std::vector<std::string> namesOf (const std::vector<ComparedCase>& cases, std::string ComparedCase::*name)
{
    std::vector<std::string> names;

    for (const auto& each : cases)
        if (std::find (names.begin(), names.end(), each.*name) == names.end())
            names.push_back (each.*name);

    return names;
}

using NumberOf = std::function<double (const ComparedCase&)>;

/** A bar for each device, side by side for each of what is played. */
ReportFigure barFigure (const std::vector<ComparedCase>& cases, const std::string& caption, const std::string& label,
                        const NumberOf& numberOf)
{
    BarChart chart;
    chart.yLabel = label;
    chart.categories = namesOf (cases, &ComparedCase::device);

    for (const auto& played : namesOf (cases, &ComparedCase::played))
    {
        auto& series = chart.series.emplace_back();
        series.name = played;
        series.values =
            Eigen::VectorXd::Constant (static_cast<Eigen::Index> (chart.categories.size()), ComparedCase::unknown);

        for (const auto& each : cases)
            if (const auto device = std::find (chart.categories.begin(), chart.categories.end(), each.device);
                each.played == played && each.error.empty())
                series.values[device - chart.categories.begin()] = numberOf (each);
    }

    return { caption, {}, std::move (chart) };
}

double weakestLevel (const ComparedCase& compared)
{
    const auto weakest = std::min_element (compared.levels.begin(), compared.levels.end());
    return weakest == compared.levels.end() ? ComparedCase::unknown : *weakest;
}
} // namespace

ReportTable comparisonTable (const std::vector<ComparedCase>& cases)
{
    ReportTable table { "One row per device and focus or waveforms; felt levels in the order of the places",
                        { "device", "played", "ceramics", "peak (V)", "limit (V)", "current (mA)", "energy (uJ)",
                          "felt (dB SL)", "contrast (dB)", "19 of 20 devices" },
                        {} };

    for (const auto& each : cases)
    {
        auto& row = table.rows.emplace_back();
        row = { each.device, each.played };

        if (each.error.empty())
            row.insert (row.end(),
                        { std::to_string (each.ceramics), numberOrNone (each.peakVoltage),
                          numberOrNone (each.voltageLimit), numberOrNone (each.peakCurrent * milli),
                          numberOrNone (each.energy * micro), levelsInWords (each),
                          std::isfinite (each.contrast) ? fixedText (each.contrast, 1) : "-", each.tolerance });

        row.resize (table.header.size(), "-");

        if (! each.error.empty())
            row.back() = each.error;
    }

    return table;
}

ReportPage comparisonReport (const std::vector<ComparedCase>& cases)
{
    ReportPage page;
    page.title = "Comparison of " + std::to_string (namesOf (cases, &ComparedCase::device).size()) + " devices";
    ReportSection numbers;
    numbers.heading = "At a glance";
    numbers.paragraphs = { "Levels are decibels over the threshold of a resting fingertip. The contrast is from the "
                           "weakest wanted place to the strongest other one, farther than 30 mm or a silent finger." };
    numbers.tables = { comparisonTable (cases) };
    ReportSection charts;
    charts.heading = "What each device needs and gives";
    charts.figures = { barFigure (cases, "Peak voltage of all ceramics.", "peak voltage (V)",
                                  [] (const ComparedCase& each) { return each.peakVoltage; }),
                       barFigure (cases, "Electrical energy of one play.", "energy (uJ)",
                                  [] (const ComparedCase& each) { return each.energy * micro; }),
                       barFigure (cases, "Felt level at the weakest place.", "felt level (dB SL)", &weakestLevel),
                       barFigure (cases, "Felt contrast.", "contrast (dB)",
                                  [] (const ComparedCase& each) { return each.contrast; }) };
    page.sections = { std::move (numbers), std::move (charts) };
    page.links = { { "scores.csv", "scores.csv" } };
    page.footer = "Antinode " ANTINODE_VERSION;
    return page;
}
} // namespace antinode
