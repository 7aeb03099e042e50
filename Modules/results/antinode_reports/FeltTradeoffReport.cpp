#include "FeltTradeoffReport.h"

#include <antinode_base/NumberText.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace antinode
{
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
} // namespace antinode
