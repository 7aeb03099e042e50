#include "TradeoffReport.h"

#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusWords.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <string_view>

namespace antinode
{
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
