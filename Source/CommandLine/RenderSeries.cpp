#include "RenderSeries.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_library/Inputs.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

namespace antinode
{
namespace
{
constexpr std::array moreIsBetter { "v_score",  "v_score_truncated", "peak_ratio",        "peak_ratio_truncated",
                                    "contrast", "captured",          "shortest_period_ms" };

/** Letters, digits, points and hyphens; what else there is becomes a hyphen. */
std::string folderName (const std::string& name)
{
    auto plain = name;
    std::replace_if (
        plain.begin(), plain.end(),
        [] (char c) { return std::isalnum (static_cast<unsigned char> (c)) == 0 && c != '.' && c != '-' && c != '_'; },
        '-');
    return plain.empty() || plain.front() == '.' ? "focus" + plain : plain;
}

void add (std::vector<SeriesFocus>& series, std::set<std::string>& taken, const std::string& name,
          FocusDescription focus)
{
    auto folder = folderName (name);

    for (int i = 2; ! taken.insert (folder).second; ++i)
        folder = folderName (name) + "-" + std::to_string (i);

    series.push_back ({ folder, std::move (focus) });
}

std::vector<std::string> numberKeys (const std::vector<SeriesResult>& results)
{
    std::vector<std::string> keys;

    for (const auto& result : results)
        for (const auto& [key, value] : result.numbers)
            if (std::find (keys.begin(), keys.end(), key) == keys.end())
                keys.push_back (key);

    return keys;
}

} // namespace

std::vector<SeriesFocus> readSeries (const std::vector<std::string>& names, const std::string& placesFile,
                                     const std::vector<std::string>& assignments)
{
    std::vector<SeriesFocus> series;
    std::set<std::string> taken;

    for (const auto& name : names)
    {
        const auto focus = loadFocus (name, assignments);
        const auto title = focus.name.empty() ? "focus" : focus.name;

        if (placesFile.empty())
        {
            add (series, taken, title, focus);
            continue;
        }

        const auto places = readPointsFile (placesFile);

        for (Eigen::Index i = 0; i < places.rows(); ++i)
        {
            auto moved = focus;
            moved.targets.front().x = places (i, 0);
            moved.targets.front().y = places (i, 1);
            add (series, taken, title + "-" + std::to_string (i + 1), moved);
        }
    }

    return series;
}

std::vector<std::pair<std::string, double>> summaryNumbers (const nlohmann::ordered_json& summary)
{
    std::vector<std::pair<std::string, double>> numbers;

    if (! summary["targets"].empty())
    {
        const auto& place = summary["targets"][0]["wanted_place_mm"];
        numbers = { { "x_mm", place[0].get<double>() }, { "y_mm", place[1].get<double>() } };
    }

    if (summary.contains ("felt") && summary["felt"]["contrast_dB"].is_number())
        numbers.emplace_back ("felt_contrast_dB", summary["felt"]["contrast_dB"].get<double>());

    for (const auto& [key, value] : summary.items())
        if (value.is_number())
            numbers.emplace_back (key, value.get<double>());

    return numbers;
}

double seriesNumber (const SeriesResult& result, const std::string& key)
{
    const auto found = std::find_if (result.numbers.begin(), result.numbers.end(),
                                     [&] (const auto& each) { return each.first == key; });
    return found != result.numbers.end() ? found->second : std::nan ("");
}

std::vector<SeriesResult> ranked (std::vector<SeriesResult> results, const std::string& rankBy)
{
    const auto keys = numberKeys (results);

    if (! keys.empty() && std::find (keys.begin(), keys.end(), rankBy) == keys.end())
        throw InputError ("--rank-by",
                          "is " + inQuotes (rankBy) + "; allowed: " + listed ({ keys.begin(), keys.end() }));

    const auto sign = std::find (moreIsBetter.begin(), moreIsBetter.end(), rankBy) == moreIsBetter.end() ? 1 : -1;
    const auto place = [&] (const SeriesResult& result)
    {
        const auto value = seriesNumber (result, rankBy);
        return std::isnan (value) ? std::numeric_limits<double>::infinity() : sign * value;
    };
    std::stable_sort (results.begin(), results.end(),
                      [&] (const auto& a, const auto& b) { return place (a) < place (b); });
    return results;
}

std::string scoreTable (const std::vector<SeriesResult>& results)
{
    const auto keys = numberKeys (results);
    std::string text = "folder";

    for (const auto& key : keys)
        text += "," + key;

    text += ",error\n";

    for (const auto& result : results)
    {
        text += result.folder;

        for (const auto& key : keys)
        {
            const auto value = seriesNumber (result, key);
            text += std::isnan (value) ? "," : formatted (",%.9g", value);
        }

        text += "," + (result.error.empty() ? "" : csvField (result.error)) + "\n";
    }

    return text;
}
} // namespace antinode
