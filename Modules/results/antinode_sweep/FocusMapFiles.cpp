#include "FocusMap.h"

#include <antinode_base/Prefixes.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
nlohmann::ordered_json mapToJson (const FocusMap& map)
{
    const auto failed =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); });
    const auto shared =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return place.isShared; });
    nlohmann::ordered_json json { { "device", map.device },
                                  { "focus", map.focus },
                                  { "columns", map.columns },
                                  { "rows", map.rows },
                                  { "places", map.places.size() },
                                  { "failed", failed },
                                  { "shared", shared },
                                  { "voltage_limit_V", map.voltageLimit },
                                  { "x_mm", { map.xMinimum * milli, map.xMaximum * milli } },
                                  { "y_mm", { map.yMinimum * milli, map.yMaximum * milli } } };
    return json;
}

std::string mapToCsv (const FocusMap& map, const std::function<std::string (std::string)>& inWords)
{
    constexpr int digits = 9;
    std::string text = "x_mm,y_mm,modes_controlled,captured,v_score,field_error,peak_voltage_V,spill_over,"
                       "felt_contrast_dB,error\n";

    for (const auto& place : map.places)
    {
        appendCsvNumber (text, place.x * milli, digits);
        text += ',';
        appendCsvNumber (text, place.y * milli, digits);

        if (! place.error.empty())
        {
            text += ",,,,,,,," + csvField (inWords (place.error)) + "\n";
            continue;
        }

        text += "," + std::to_string (place.controlled);

        for (const auto value : { place.captured, place.vScore, place.fieldError, place.peakVoltage, place.spillOver })
        {
            text += ',';
            appendCsvNumber (text, value, digits);
        }

        text += ',';

        if (place.contrast)
            appendCsvNumber (text, *place.contrast, digits);

        text += ",\n";
    }

    return text;
}
} // namespace antinode
