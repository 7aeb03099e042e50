#include "Commands.h"
#include "CommonOptions.h"
#include "FieldNames.h"
#include "FocusOnDevice.h"
#include "Progress.h"
#include "RenderFiles.h"
#include "RenderSeries.h"
#include "WrittenDesign.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_render/FingerMotion.h>
#include <antinode_render/Summary.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace antinode
{
namespace
{
struct RenderCommandOptions
{
    CommonOptions common;
    std::vector<std::string> probes;
    std::optional<double> duration; // ms
    int blockSize = 512;
    RenderedFiles files;
    std::vector<std::string> focuses { "demonstrator" };
    std::string designFile, placesFile, rankBy = "field_error";
};

/** "X" or "X,Y" in mm. */
std::pair<double, double> parseProbe (const std::string& text)
{
    double values[2] = { 0, 0 };
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (auto& value : values)
    {
        const auto [next, error] = std::from_chars (at, end, value);

        if (error != std::errc() || (next != end && *next != ','))
            throw InputError ("--probe " + text, "is not a position; allowed: X or X,Y in mm, for example 24 or 24,10");

        at = next == end ? end : next + 1;

        if (next == end)
            return { values[0] / 1000, values[1] / 1000 };
    }

    throw InputError ("--probe " + text, "has more than two numbers; allowed: X or X,Y in mm");
}

RenderOptions renderOptions (const RenderCommandOptions& options)
{
    RenderOptions result;
    result.playback = options.common.playback();
    result.blockSize = options.blockSize;
    result.repetitions = options.common.repetitions;
    result.threshold = findSkinThreshold (options.common.thresholdFile);

    if (options.duration)
        result.duration = *options.duration / 1000;

    for (const auto& probe : options.probes)
        result.probes.push_back (parseProbe (probe));

    return result;
}

void printSummary (const RenderedFocus& focus, const FocusOutcome& outcome, const RenderCommandOptions& options)
{
    const auto& design = focus.design;
    std::printf ("%s on %s\n", design.description.name.c_str(), focus.model.name.c_str());
    std::printf ("%s", outcomeToText (focus, outcome).c_str());
    std::printf ("Scores against the wanted field, and against the part that the controlled modes represent:\n");
    std::printf ("  v-score        %.4f, %.6f\n", focus.score.vScore, focus.truncatedScore.vScore);
    std::printf ("  field error    %.2f %%, %.4f %%\n", 100 * focus.score.fieldError,
                 100 * focus.truncatedScore.fieldError);

    if (outcome.expected)
        std::printf ("  on the device  %s\n", outcome.expected->sentence.c_str());

    std::printf ("  captured       %.4f by %zu of %td modes\n", design.captured, design.controlledModes.size(),
                 focus.known.modes());
    std::printf ("  %s\n", spillOverToText (focus).c_str());

    if (! design.weighing.empty())
        std::printf ("  modes          %s\n", design.weighing.c_str());

    printPower (focus.model, *focus.power);

    if (design.limit)
        std::printf ("  voltages       %s\n", limitSentence (focus.model, *design.limit).c_str());

    for (const auto& line : fingersToText (focus))
        std::printf ("  %s\n", line.c_str());

    for (const auto& warning : design.warnings)
        std::printf ("  warning: %s\n", warning.c_str());

    std::printf ("Figures and scores: %s/%s\n", options.common.folder.c_str(),
                 options.files.hasReport ? "report.html" : "summary.json");
}

void renderOne (const RenderCommandOptions& options)
{
    Progress progress (options.common.isQuiet);
    const auto settings = renderOptions (options);
    auto made =
        options.designFile.empty() ? designFrom (options.common) : writtenDesign (options.common, options.designFile);
    const auto focus = renderFocus (std::move (made.wide), std::move (made.design), settings,
                                    [&] (double share) { progress.show ("Rendering", share); });
    const auto outcome = evaluateOutcome (focus);
    writeRendered (options.common.folder, focus, outcome, options.files);

    if (! options.common.isQuiet)
        printSummary (focus, outcome, options);
}

SeriesResult renderOfSeries (const WideModel& wide, const SeriesFocus& each, const RenderCommandOptions& options)
{
    try
    {
        checkKindOfPlaces (wide.model, each.focus);
        auto made = designFrom (options.common, wide, each.focus);
        const auto focus = renderFocus (std::move (made.wide), std::move (made.design), renderOptions (options));
        const auto outcome = evaluateOutcome (focus);
        writeRendered (std::filesystem::path (options.common.folder) / each.folder, focus, outcome, options.files);
        return { each.folder, summaryNumbers (summaryToJson (focus, outcome)), {} };
    }
    catch (const InputError& error)
    {
        return { each.folder, {}, withKeysAndOptions (error.what()) };
    }
}

void printRanking (const std::vector<SeriesResult>& results, const RenderCommandOptions& options)
{
    std::printf ("%4s  %-24s %12s  %s\n", "rank", "folder", options.rankBy.c_str(), "peak voltage");

    for (std::size_t i = 0; i < results.size(); ++i)
        if (const auto& each = results[i]; each.error.empty())
            std::printf ("%4zu  %-24s %12s  %s V of %s V\n", i + 1, each.folder.c_str(),
                         inWords (seriesNumber (each, options.rankBy)).c_str(),
                         inWords (seriesNumber (each, "peak_voltage_V")).c_str(),
                         inWords (seriesNumber (each, "voltage_limit_V")).c_str());
        else
            std::printf ("   -  %-24s failed: %s\n", each.folder.c_str(), each.error.c_str());

    std::printf ("All numbers: %s/scores.csv\n", options.common.folder.c_str());
}

/** Each focus into a folder of its own, and a table of all. What one of them cannot do does not stop the others. */
void renderSeries (const RenderCommandOptions& options)
{
    Progress progress (options.common.isQuiet);
    const auto wide = wideFrom (options.common, modelFrom (options.common));
    const auto series = readSeries (options.focuses, options.placesFile, options.common.assignments);
    std::vector<SeriesResult> results;

    for (const auto& each : series)
    {
        progress.show (formatted ("Focus %zu of %zu", results.size() + 1, series.size()),
                       static_cast<double> (results.size()) / static_cast<double> (series.size()));
        results.push_back (renderOfSeries (wide, each, options));
        writeWholeFile (std::filesystem::path (options.common.folder) / "scores.csv", scoreTable (results));
    }

    results = ranked (std::move (results), options.rankBy);
    writeWholeFile (std::filesystem::path (options.common.folder) / "scores.csv", scoreTable (results));

    if (! options.common.isQuiet)
        printRanking (results, options);

    const auto failed =
        std::count_if (results.begin(), results.end(), [] (const auto& each) { return ! each.error.empty(); });

    if (failed > 0)
        throw InputError ("render", std::to_string (failed) + " of " + std::to_string (results.size())
                                        + " focuses failed; scores.csv says why");
}
} // namespace

void addRenderCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("render", "Renders a focus: voltages, velocities, scores and a report with figures");
    auto options = std::make_shared<RenderCommandOptions>();
    auto* focus = command->add_option (
        "focus", options->focuses, "Focus: an embedded name or a .json file; several: each into a folder of its own");
    focus->capture_default_str();
    addCommonOptions (*command, options->common);
    auto* design = command->add_option ("--design", options->designFile,
                                        "Plays a design.json that was written before, in place of a focus");
    design->type_name ("FILE")->excludes (focus)->excludes (command->get_option ("--finger"));
    command->add_option ("--probe", options->probes, "Position of a velocity probe, mm (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("X,Y");
    command->add_option ("--duration-ms", options->duration, "Rendered duration from the trigger, ms");
    command->add_option ("--block-size", options->blockSize, "Samples per block; does not affect the result")
        ->check (CLI::Range (1, 8193))
        ->capture_default_str();
    command->add_option ("--format", options->files.format, "Format of the voltages")
        ->check (CLI::IsMember ({ "wav", "csv", "mat", "tfw" }))
        ->capture_default_str();
    command->add_flag ("!--no-report", options->files.hasReport, "Writes no report.html");
    command
        ->add_option ("--figures", options->files.figures,
                      "Also writes the figures of the report for print: svg, pdf (repeatable)")
        ->check (CLI::IsMember ({ "svg", "pdf" }))
        ->allow_extra_args (false);
    command->add_option ("--threshold", options->common.thresholdFile,
                         "CSV of Hz and um: what skin feels, in place of the built-in table");
    command->add_option ("--places", options->placesFile, "CSV of x and y in mm: the focus at each of these places")
        ->excludes (design);
    command
        ->add_option ("--rank-by", options->rankBy,
                      "Number of summary.json by which several focuses are ranked in scores.csv")
        ->capture_default_str();
    command->callback (
        [options]
        {
            auto& common = options->common;
            common.focus = options->focuses.front();

            if (! options->designFile.empty())
                completeFrom (common, options->designFile);
            else
                common.device =
                    deviceFor (LibraryKind::focus, options->focuses, common.device, usualDevice, common.assignments);

            if (options->focuses.size() == 1 && options->placesFile.empty())
                renderOne (*options);
            else
                renderSeries (*options);
        });
}
} // namespace antinode
