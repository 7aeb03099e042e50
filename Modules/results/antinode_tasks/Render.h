#pragma once

#include "Design.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** Which files of a render are wanted. */
struct RenderedFiles
{
    std::string format = "wav"; ///< Of the voltages: "wav", "csv", "mat", "tfw".
    bool hasReport = true;
    std::vector<std::string> figures; ///< "svg", "pdf": those of the report for print.
};

/** Writes the voltages and the probe velocities of a rendered focus: voltages.wav and probe.wav, with format "csv"
   voltages.csv instead, with "mat" voltages.mat, with "tfw" one voltages-NN.tfw a ceramic and their settings in
   voltages-tfw.csv; probe.csv always. 1.0 in voltages.wav is the full scale of the device, in probe.wav 1 m/s.
    @throws InputError  when a format cannot hold the samples
    [worker] Docs/FileFormats.md. */
void writeSamples (OutputFolder&, const RenderedFocus&, const std::string& format);

/** Writes all files of a rendered focus into a folder, which is made where it is missing.
    @throws InputError  as writeSamples, or when the folder cannot be written
    [worker] Docs/FileFormats.md. */
void writeRendered (const std::filesystem::path&, const RenderedFocus&, const FocusOutcome&, const RenderedFiles&);

inline constexpr TaskText renderText { "render",
                                       "Renders a focus: voltages, velocities, scores and a report with figures",
                                       "Docs/Theory.md, sections 5 and 6" };

/** What is played on the plate model, and what is recorded of it. */
struct RenderRequest
{
    FocusRequest design;
    std::shared_ptr<const DesignedFocus> made;     ///< Played as it is, in place of a new design.
    std::vector<std::pair<double, double>> probes; ///< x, y, m; empty: those of the focus, or its targets.
    std::optional<double> duration;                ///< s from the trigger; none: until the surface has calmed down.
    int blockSize = 512;
};

/** [any] */
std::vector<Field> fields (RenderRequest&);

/** A focus as the plate model played it. */
struct RenderedDesign
{
    std::shared_ptr<const DesignedFocus> design;
    RenderedFocus focus;
    FocusOutcome outcome;
};

/** How a design is played. @throws InputError  for a threshold that cannot be read [worker] */
RenderOptions renderOptions (const RenderRequest&, const DesignedFocus&);

/** Designs a focus where there is no design, and plays it on the plate model.
    @throws InputError, LimitError  as design and renderFocus [worker] */
RenderedDesign render (const RenderRequest&, const ShowProgress&);

/** Writes the fields of all foci as tables: field.csv at the points of the surface and, of a plate, section.csv along x
   and y through the first target. Wanted, represented by the controlled modes, reached. [worker] Docs/FileFormats.md.
 */
void writeFields (OutputFolder&, const RenderedFocus&);

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
    them felt_level_dB of the weakest target or finger with a track, energy_J, peak_current_A and peak_power_W. [any]
   Docs/FileFormats.md. */
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
