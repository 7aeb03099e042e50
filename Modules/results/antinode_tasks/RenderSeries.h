#pragma once

#include <antinode_focus/FocusDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** A focus of a series and the folder that it is rendered into. */
struct SeriesFocus
{
    std::string folder; ///< A plain name; no two of a series have the same.
    FocusDescription focus;
};

/** What a focus of a series has come to. */
struct SeriesResult
{
    std::string folder;
    std::vector<std::pair<std::string, double>> numbers; ///< As summaryNumbers gives them; none where it failed.
    std::string error;                                   ///< Why it failed, or empty.
};

/** The focuses of files or embedded names; with places, each of them at every place.
    @param assignments  as loadFocus
    @param placesFile   CSV of x and y in mm, or empty; the first target moves there
    @throws InputError  for anything that cannot be read
    [worker] */
std::vector<SeriesFocus> readSeries (const std::vector<std::string>& names, const std::string& placesFile,
                                     const std::vector<std::string>& assignments);

/** The numbers of a summary, by their keys, behind those of the object that they stand in ("felt_contrast_dB"); before
    them felt_level_dB of the weakest target, energy_J, peak_current_A and peak_power_W. [any] Docs/FileFormats.md. */
std::vector<std::pair<std::string, double>> summaryNumbers (const nlohmann::ordered_json& summary);

/** The number of a key; NaN where there is none. [any] */
double seriesNumber (const SeriesResult&, const std::string& key);

/** The results from the best to the worst: those with the smallest score first, failed ones last.
    @param rankBy       a number of summary.json; those of which more is better (v_score, peak_ratio, contrast,
   captured) are ranked from the largest
    @throws InputError  "--rank-by" where it is no number of summary.json [any] */
std::vector<SeriesResult> ranked (std::vector<SeriesResult>, const std::string& rankBy);

/** All numbers of the summaries as a table: a line for each result, in their order. Docs/FileFormats.md. [any] */
std::string scoreTable (const std::vector<SeriesResult>&);
} // namespace antinode
