#include "TradeoffReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusWords.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

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

std::vector<std::string> tableCells (const TradeoffPoint& point)
{
    if (! point.failure.empty())
        return { methodText (point), settingText (point), "-", "-", "-", "-", point.failure };

    return { methodText (point),
             settingText (point),
             inWords (point.peakVoltage),
             inWords (point.timeInMotion * milli),
             inWords (point.vScore),
             inWords (point.fieldError),
             point.isOnFront ? "front" : "" };
}

const std::vector<std::string>& header()
{
    static const std::vector<std::string> names { "method",  "setting",     "peak (V)", "in motion (ms)",
                                                  "v-score", "field error", "" };
    return names;
}

std::string missingPoints (const Tradeoff& tradeoff)
{
    return "Interrupted after " + std::to_string (tradeoff.points.size()) + " of " + std::to_string (tradeoff.planned)
           + " designs; the front is that of these.";
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

nlohmann::ordered_json tradeoffToJson (const Tradeoff& tradeoff, const std::string& focus, const std::string& device)
{
    nlohmann::ordered_json json { { "schema", "antinode.tradeoff/1" },
                                  { "focus", focus },
                                  { "device", device },
                                  { "lower_bound_voltage_V", tradeoff.lowerBoundVoltage },
                                  { "lower_bound_gap", tradeoff.lowerBoundGap },
                                  { "planned_points", tradeoff.planned } };
    json["points"] = nlohmann::ordered_json::array();

    for (const auto& point : tradeoff.points)
    {
        nlohmann::ordered_json item { { "method", methodText (point) } };

        if (point.envelopeFolds > 0)
            item["envelope_folds"] = point.envelopeFolds;

        if (point.limitMultiple > 0)
            item["limit_by_lower_bound"] = point.limitMultiple;

        if (! point.failure.empty())
            item["failure"] = point.failure;
        else
        {
            item["peak_voltage_V"] = point.peakVoltage;
            item["time_in_motion_ms"] = point.timeInMotion * milli;
            item["v_score_truncated"] = point.vScore;
            item["field_error_truncated"] = point.fieldError;
            item["on_front"] = point.isOnFront;
        }

        json["points"].push_back (item);
    }

    return json;
}

std::string tradeoffToCsv (const Tradeoff& tradeoff)
{
    constexpr int digits = 9;
    std::string text = "method,envelope_folds,limit_by_lower_bound,peak_voltage_V,time_in_motion_ms,v_score_truncated,"
                       "field_error_truncated,on_front\r\n";

    for (const auto& point : tradeoff.points)
        if (point.failure.empty())
        {
            text += csvField (methodText (point));

            for (const auto value :
                 { point.envelopeFolds, point.limitMultiple, point.peakVoltage, point.timeInMotion * milli,
                   point.vScore, point.fieldError, point.isOnFront ? 1.0 : 0.0 })
            {
                text += ",";
                appendCsvNumber (text, value, digits);
            }

            text += "\r\n";
        }

    return text;
}

std::string tradeoffToText (const Tradeoff& tradeoff)
{
    const auto line = [] (const std::vector<std::string>& cells)
    {
        std::array<char, 512> text {};
        std::snprintf (text.data(), text.size(), "%-14s %-12s %9s %15s %9s %12s  %s\n", cells[0].c_str(),
                       cells[1].c_str(), cells[2].c_str(), cells[3].c_str(), cells[4].c_str(), cells[5].c_str(),
                       cells[6].c_str());
        return std::string (text.data());
    };
    auto text = line (header());

    for (const auto& point : tradeoff.points)
        text += line (tableCells (point));

    if (tradeoff.points.size() < tradeoff.planned)
        text += missingPoints (tradeoff) + "\n";

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
    page.footer = "Antinode " ANTINODE_VERSION ". All numbers are computed in closed form.";
    return page;
}
} // namespace antinode
