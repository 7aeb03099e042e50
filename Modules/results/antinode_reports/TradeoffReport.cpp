#include "TradeoffReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

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

namespace
{
using Level = std::optional<double>;

const std::vector<std::string>& feltColumns()
{
    static const std::vector<std::string> names { "weight",         "peak (V)",        "field error",   "target (dB)",
                                                  "elsewhere (dB)", "bystanders (dB)", "contrast (dB)", "" };
    return names;
}

/** The target over the bystanders where there are any, else over the largest level elsewhere. */
Level contrastOf (const FeltTradeoffPoint& point)
{
    const auto& other = point.bystanders ? point.bystanders : point.elsewhere;
    return other && point.failure.empty() ? Level (point.target - *other) : std::nullopt;
}

std::string levelCell (const Level& level)
{
    return level ? fixedText (*level, 1) : "-";
}

std::vector<std::string> feltCells (const FeltTradeoffPoint& point)
{
    if (! point.failure.empty())
        return { inWords (point.weight), "-", "-", "-", "-", "-", "-", point.failure };

    return { inWords (point.weight),         inWords (point.peakVoltage),
             inWords (point.fieldError),     fixedText (point.target, 1),
             levelCell (point.elsewhere),    levelCell (point.bystanders),
             levelCell (contrastOf (point)), "" };
}

nlohmann::ordered_json levelJson (const Level& level)
{
    return level ? nlohmann::ordered_json (*level) : nlohmann::ordered_json();
}

std::string feltPointsMissing (const FeltTradeoff& tradeoff)
{
    return "Interrupted after " + std::to_string (tradeoff.points.size()) + " of " + std::to_string (tradeoff.planned)
           + " designs.";
}

LineChart feltTradeoffChart (const FeltTradeoff& tradeoff)
{
    Series series;
    series.name =
        "weight " + inWords (tradeoff.points.front().weight) + " to " + inWords (tradeoff.points.back().weight);
    series.points = true;
    std::vector<double> contrasts, volts;

    for (const auto& point : tradeoff.points)
        if (const auto contrast = contrastOf (point))
        {
            contrasts.push_back (*contrast);
            volts.push_back (point.peakVoltage);
        }

    const auto count = static_cast<Eigen::Index> (volts.size());
    series.x = Eigen::Map<const Eigen::VectorXd> (contrasts.data(), count);
    series.y = Eigen::Map<const Eigen::VectorXd> (volts.data(), count);
    LineChart chart;
    chart.xLabel = "felt contrast (dB)";
    chart.yLabel = "peak voltage (V)";
    chart.series = { std::move (series) };

    if (count > 0)
        chart.yRange = AxisRange { 0, 1.05 * chart.series.front().y.maxCoeff() };

    return chart;
}
} // namespace

nlohmann::ordered_json feltTradeoffToJson (const FeltTradeoff& tradeoff, const std::string& focus,
                                           const std::string& device)
{
    nlohmann::ordered_json json { { "schema", "antinode.felt_tradeoff/1" },
                                  { "focus", focus },
                                  { "device", device },
                                  { "threshold", tradeoff.threshold },
                                  { "planned_points", tradeoff.planned } };
    json["points"] = nlohmann::ordered_json::array();

    for (const auto& point : tradeoff.points)
    {
        nlohmann::ordered_json item { { "weight", point.weight } };

        if (! point.failure.empty())
            item["failure"] = point.failure;
        else
        {
            item["peak_voltage_V"] = point.peakVoltage;
            item["field_error_truncated"] = point.fieldError;
            item["target_level_dB"] = point.target;
            item["elsewhere_level_dB"] = levelJson (point.elsewhere);
            item["bystanders_level_dB"] = levelJson (point.bystanders);
            item["contrast_dB"] = levelJson (contrastOf (point));
        }

        json["points"].push_back (item);
    }

    return json;
}

std::string feltTradeoffToCsv (const FeltTradeoff& tradeoff)
{
    constexpr int digits = 9;
    std::string text = "weight,peak_voltage_V,field_error_truncated,target_level_dB,elsewhere_level_dB,"
                       "bystanders_level_dB,contrast_dB\r\n";

    for (const auto& point : tradeoff.points)
        if (point.failure.empty())
        {
            appendCsvNumber (text, point.weight, digits);

            for (const auto& value : { Level (point.peakVoltage), Level (point.fieldError), Level (point.target),
                                       point.elsewhere, point.bystanders, contrastOf (point) })
            {
                text += ",";

                if (value)
                    appendCsvNumber (text, *value, digits);
            }

            text += "\r\n";
        }

    return text;
}

std::string feltTradeoffToText (const FeltTradeoff& tradeoff)
{
    const auto line = [] (const std::vector<std::string>& cells)
    {
        return formatted ("%8s %9s %12s %12s %15s %16s %14s  %s\n", cells[0].c_str(), cells[1].c_str(),
                          cells[2].c_str(), cells[3].c_str(), cells[4].c_str(), cells[5].c_str(), cells[6].c_str(),
                          cells[7].c_str());
    };
    auto text = line (feltColumns());

    for (const auto& point : tradeoff.points)
        text += line (feltCells (point));

    return tradeoff.points.size() < tradeoff.planned ? text + feltPointsMissing (tradeoff) + "\n" : text;
}

ReportPage feltTradeoffReport (const FeltTradeoff& tradeoff, const std::string& focus, const std::string& device)
{
    ReportSection section;
    section.heading = "Voltage against felt contrast";
    section.paragraphs = {
        "The more weight on felt levels elsewhere, the more voltage the same focus needs. Each point is a design with "
        "all controlled modes at their velocities at the focus, played on a plate with more modes. Levels are those of "
        "the whole event, over the threshold of skin ("
        + tradeoff.threshold
        + "); elsewhere is the largest farther than 30 mm from the targets. The contrast is that of the weakest target "
          "to the most disturbed bystander, or to the largest elsewhere where there are no bystanders."
    };
    section.figures.push_back ({ "Peak voltage and felt contrast by weight; from left to right the weight rises.",
                                 {},
                                 feltTradeoffChart (tradeoff),
                                 900,
                                 480 });
    ReportTable table { "All designs", feltColumns(), {} };

    for (const auto& point : tradeoff.points)
        table.rows.push_back (feltCells (point));

    section.tables.push_back (std::move (table));
    ReportPage page;
    page.title = "Less felt elsewhere: " + focus;
    page.subtitle = device;

    if (tradeoff.points.size() < tradeoff.planned)
        page.warnings = { feltPointsMissing (tradeoff) };

    page.sections = { std::move (section) };
    page.links = { { "tradeoff.json", "tradeoff.json" }, { "tradeoff.csv", "tradeoff.csv" } };
    page.footer = "Antinode " ANTINODE_VERSION ". All levels are those of a simulated plate.";
    return page;
}

namespace
{
std::string_view methodWord (const TradeoffPoint& point)
{
    return wordFor (allocationMethodWords, point.method);
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
        nlohmann::ordered_json item { { "method", methodWord (point) } };

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

            if (point.feltContrast)
                item["felt_contrast_dB"] = *point.feltContrast;
        }

        json["points"].push_back (item);
    }

    return json;
}

std::string tradeoffToCsv (const Tradeoff& tradeoff)
{
    constexpr int digits = 9;
    std::string text = "method,envelope_folds,limit_by_lower_bound,peak_voltage_V,time_in_motion_ms,v_score_truncated,"
                       "field_error_truncated,on_front,felt_contrast_dB\r\n";

    for (const auto& point : tradeoff.points)
        if (point.failure.empty())
        {
            text += csvField (std::string (methodWord (point)));

            for (const auto value :
                 { point.envelopeFolds, point.limitMultiple, point.peakVoltage, point.timeInMotion * milli,
                   point.vScore, point.fieldError, point.isOnFront ? 1.0 : 0.0 })
            {
                text += ",";
                appendCsvNumber (text, value, digits);
            }

            text += ",";

            if (point.feltContrast)
                appendCsvNumber (text, *point.feltContrast, digits);

            text += "\r\n";
        }

    return text;
}

} // namespace antinode
