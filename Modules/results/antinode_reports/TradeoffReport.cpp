#include "TradeoffReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusWords.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace antinode
{
namespace
{
std::string methodText (const TradeoffPoint& point)
{
    return std::string (wordFor (allocationMethodWords, point.method));
}

std::string settingText (const TradeoffPoint& point)
{
    if (point.envelopeFolds > 0)
        return inWords (point.envelopeFolds) + " e-folds";

    return point.limitMultiple > 0 ? inWords (point.limitMultiple) + " x bound" : "no limit";
}

std::string contrastText (const TradeoffPoint& point)
{
    return point.feltContrast ? inWords (*point.feltContrast) : "-";
}

std::vector<std::string> tableCells (const TradeoffPoint& point)
{
    if (! point.failure.empty())
        return { methodText (point), settingText (point), "-", "-", "-", "-", "-", point.failure };

    return { methodText (point),          settingText (point),
             inWords (point.peakVoltage), inWords (point.timeInMotion * milli),
             inWords (point.vScore),      inWords (point.fieldError),
             contrastText (point),        point.isOnFront ? "front" : "" };
}

const std::vector<std::string>& header()
{
    static const std::vector<std::string> names { "method",  "setting",     "peak (V)",           "in motion (ms)",
                                                  "v-score", "field error", "felt contrast (dB)", "" };
    return names;
}

std::string missingPoints (const Tradeoff& tradeoff)
{
    return "Interrupted after " + std::to_string (tradeoff.points.size()) + " of " + std::to_string (tradeoff.planned)
           + " designs; the front is that of these.";
}

std::string frontText (const TradeoffPoint& point)
{
    return inWords (point.peakVoltage) + " V and " + inWords (point.timeInMotion * milli) + " ms (" + methodText (point)
           + (point.feltContrast ? ", felt contrast " + inWords (*point.feltContrast) + " dB)" : ")");
}

/** Whether more voltage buys less motion, and how much; empty where there is no front. */
std::string frontInWords (const Tradeoff& tradeoff)
{
    const TradeoffPoint *cheapest = nullptr, *shortest = nullptr;

    for (const auto& point : tradeoff.points)
        if (point.isOnFront)
        {
            cheapest = cheapest == nullptr || point.peakVoltage < cheapest->peakVoltage ? &point : cheapest;
            shortest = shortest == nullptr || point.timeInMotion < shortest->timeInMotion ? &point : shortest;
        }

    if (cheapest == nullptr)
        return {};

    return cheapest == shortest ? "More voltage buys no less motion than " + frontText (*cheapest) + "."
                                : "More voltage buys less motion before the focus: from " + frontText (*cheapest)
                                      + " to " + frontText (*shortest) + ".";
}

/** The points of one method, from the shortest motion to the longest. */
Series makeSeries (const Tradeoff& tradeoff, AllocationMethod method)
{
    std::vector<const TradeoffPoint*> points;

    for (const auto& point : tradeoff.points)
        if (point.method == method && point.failure.empty())
            points.push_back (&point);

    std::sort (points.begin(), points.end(),
               [] (const auto* a, const auto* b) { return a->timeInMotion < b->timeInMotion; });
    Series series;
    series.name = std::string (wordFor (allocationMethodWords, method));
    series.x.resize (static_cast<Eigen::Index> (points.size()));
    series.y.resize (series.x.size());
    series.points = true;

    for (Eigen::Index i = 0; i < series.x.size(); ++i)
    {
        series.x[i] = points[static_cast<std::size_t> (i)]->timeInMotion * milli;
        series.y[i] = points[static_cast<std::size_t> (i)]->peakVoltage;
    }

    return series;
}

LineChart tradeoffChart (const Tradeoff& tradeoff)
{
    LineChart chart;
    chart.xLabel = "time in motion before the focus (ms)";
    chart.yLabel = "peak voltage (V)";
    chart.logarithmicY = true;
    double longest = 0;

    for (const auto& point : tradeoff.points)
        longest = std::max (longest, point.timeInMotion * milli);

    if (longest > 0)
        chart.xRange = AxisRange { 0, 1.03 * longest };

    for (const auto& [word, method] : allocationMethodWords)
        if (auto series = makeSeries (tradeoff, method); series.x.size() > 0)
            chart.series.push_back (std::move (series));

    if (tradeoff.lowerBoundVoltage > 0)
        chart.limits.push_back ({ tradeoff.lowerBoundVoltage, "lower bound" });

    return chart;
}
} // namespace

std::string tradeoffToText (const Tradeoff& tradeoff)
{
    const auto line = [] (const std::vector<std::string>& cells)
    {
        std::array<char, 512> text {};
        std::snprintf (text.data(), text.size(), "%-14s %-12s %9s %15s %9s %12s %19s  %s\n", cells[0].c_str(),
                       cells[1].c_str(), cells[2].c_str(), cells[3].c_str(), cells[4].c_str(), cells[5].c_str(),
                       cells[6].c_str(), cells[7].c_str());
        return std::string (text.data());
    };
    auto text = line (header());

    for (const auto& point : tradeoff.points)
        text += line (tableCells (point));

    if (tradeoff.points.size() < tradeoff.planned)
        text += missingPoints (tradeoff) + "\n";

    if (const auto front = frontInWords (tradeoff); ! front.empty())
        text += front + "\n";

    return text + "Lower bound for all waveforms: " + inWords (tradeoff.lowerBoundVoltage) + " V.\n";
}

ReportPage tradeoffReport (const Tradeoff& tradeoff, const std::string& focus, const std::string& device)
{
    ReportSection section;
    section.heading = "Voltage against time in motion";
    section.paragraphs = {
        "A longer motion before the focus needs less voltage. Each point is a design without a voltage limit. "
        "The time in motion is the time before the focus during which the norm of the modal velocities exceeds "
        "half of its value at the focus. A point is on the front if no other design with a field error below "
        "5 % has both less voltage and less time."
    };

    if (const auto front = frontInWords (tradeoff); ! front.empty())
        section.paragraphs.push_back (front);

    section.figures.push_back (
        { "Peak voltage and time in motion by method. Along a curve the growth changes; for free "
          "waveforms, the voltage limit changes. The line is the lower bound for all waveforms.",
          {},
          tradeoffChart (tradeoff),
          900,
          480 });
    ReportTable table { "All designs", header(), {} };

    for (const auto& point : tradeoff.points)
        table.rows.push_back (tableCells (point));

    section.tables.push_back (std::move (table));
    ReportPage page;
    page.title = "Trade-off: " + focus;
    page.subtitle = device + ", lower bound for all waveforms " + inWords (tradeoff.lowerBoundVoltage) + " V";

    if (tradeoff.points.size() < tradeoff.planned)
        page.warnings = { missingPoints (tradeoff) };

    page.sections = { std::move (section) };
    page.links = { { "tradeoff.json", "tradeoff.json" }, { "tradeoff.csv", "tradeoff.csv" } };
    page.footer = "Antinode " ANTINODE_VERSION ". Voltages, times and scores are computed in closed form; felt "
                  "contrast is that of a render by the controlled modes.";
    return page;
}
} // namespace antinode
