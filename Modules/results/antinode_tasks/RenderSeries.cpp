#include "RenderSeries.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Inputs.h>
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
constexpr std::array moreIsBetter {
    "v_score",  "v_score_truncated",  "peak_ratio",    "peak_ratio_truncated", "contrast",
    "captured", "shortest_period_ms", "felt_level_dB", "felt_contrast_dB",     "event_contrast"
};

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

using Numbers = std::vector<std::pair<std::string, double>>;

/** The numbers of an object and of objects in it, whose names stand before theirs: felt_contrast_dB. Lists are of
   single targets, ceramics and places. */
void addNumbers (Numbers& numbers, const nlohmann::ordered_json& object, const std::string& before)
{
    for (const auto& [key, value] : object.items())
        if (value.is_number())
            numbers.emplace_back (before + key, value.get<double>());
        else if (value.is_object())
            addNumbers (numbers, value, before + key + "_");
}

/** The weakest target's. */
void addFeltLevel (Numbers& numbers, const nlohmann::ordered_json& summary)
{
    if (! summary.contains ("felt"))
        return;

    auto weakest = std::numeric_limits<double>::infinity();

    for (const auto& target : summary["felt"]["targets"])
        weakest = std::min (weakest, target["level_dB"].get<double>());

    if (std::isfinite (weakest))
        numbers.emplace_back ("felt_level_dB", weakest);
}

/** Of all ceramics, in SI units. */
void addPower (Numbers& numbers, const nlohmann::ordered_json& summary)
{
    if (! summary.contains ("power") || ! summary["power"].contains ("per_focus"))
        return;

    const auto& once = summary["power"]["per_focus"];
    numbers.emplace_back ("energy_J", once["electrical_in_uJ"].get<double>() / micro);
    numbers.emplace_back ("peak_current_A", once["peak_current_mA"].get<double>() / milli);
    numbers.emplace_back ("peak_power_W", once["peak_power_mW"].get<double>() / milli);
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

    addFeltLevel (numbers, summary);
    addPower (numbers, summary);
    addNumbers (numbers, summary, {});
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
