#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_render/FingerMotion.h>
#include <antinode_render/Summary.h>
#include <antinode_tasks/FieldNames.h>
#include <antinode_tasks/Render.h>
#include <antinode_tasks/RenderSeries.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace antinode
{
namespace
{
/** One focus, or a series of them. */
struct RenderOfFocus
{
    RenderRequest request;
    RenderedFiles files;
    std::filesystem::path folder = "antinode-out", designFile, placesFile;
    std::vector<std::string> focuses; ///< Names of a series.
    std::string rankBy = "field_error";
    bool isQuiet = false;
};

void printSummary (const RenderedDesign& rendered, const RenderOfFocus& options)
{
    const auto& focus = rendered.focus;
    const auto& outcome = rendered.outcome;
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

    std::printf ("Figures and scores: %s/%s\n", options.folder.c_str(),
                 options.files.hasReport ? "report.html" : "summary.json");
}

void renderOne (const RenderOfFocus& options)
{
    Progress progress (options.isQuiet);
    const auto rendered = render (options.request, progress.shown());
    writeRendered (options.folder, rendered.focus, rendered.outcome, options.files);

    if (! options.isQuiet)
        printSummary (rendered, options);
}

SeriesResult renderOfSeries (const Setup& setup, const SeriesFocus& each, const RenderOfFocus& options)
{
    try
    {
        auto request = options.request;
        request.design.focus = each.focus;
        request.made = std::make_shared<const DesignedFocus> (
            DesignedFocus { designOn (setup, focusOf (request.design)), setup.playback, request.design.repetitions,
                            request.design.thresholdFile });
        const auto rendered = render (request, {});
        writeRendered (options.folder / each.folder, rendered.focus, rendered.outcome, options.files);
        return { each.folder, summaryNumbers (summaryToJson (rendered.focus, rendered.outcome)), {} };
    }
    catch (const InputError& error)
    {
        return { each.folder, {}, withKeysAndOptions (error.what()) };
    }
}

void printRanking (const std::vector<SeriesResult>& results, const RenderOfFocus& options)
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

    std::printf ("All numbers: %s/scores.csv\n", options.folder.c_str());
}

/** Each focus into its own folder, and a table of all. What one of them cannot do does not stop the others. */
void renderSeries (const RenderOfFocus& options, const std::vector<std::string>& assignments)
{
    Progress progress (options.isQuiet);
    const auto& design = options.request.design;
    const auto setup = setUp (design.device, playbackOf (design), design.usesCache);
    const auto series = readSeries (options.focuses, options.placesFile.string(), assignments);
    std::vector<SeriesResult> results;

    for (const auto& each : series)
    {
        progress.show (formatted ("Focus %zu of %zu", results.size() + 1, series.size()),
                       static_cast<double> (results.size()) / static_cast<double> (series.size()));
        results.push_back (renderOfSeries (setup, each, options));
        writeWholeFile (options.folder / "scores.csv", scoreTable (results));
    }

    results = ranked (std::move (results), options.rankBy);
    writeWholeFile (options.folder / "scores.csv", scoreTable (results));

    if (! options.isQuiet)
        printRanking (results, options);

    const auto failed =
        std::count_if (results.begin(), results.end(), [] (const auto& each) { return ! each.error.empty(); });

    if (failed > 0)
        throw InputError ("render", std::to_string (failed) + " of " + std::to_string (results.size())
                                        + " focuses failed; scores.csv says why");
}

std::shared_ptr<const DesignedFocus> playedDesign (const RenderOfFocus& options, const CLI::App& command,
                                                   const std::vector<std::string>& assignments)
{
    const auto* const device = command.get_option ("--device");
    const auto isOpen = [&] (const char* option) { return command.get_option (option)->count() == 0; };
    return std::make_shared<const DesignedFocus> (
        writtenDesign (options.request.design, { isOpen ("--rate"), isOpen ("--reconstruction") }, options.designFile,
                       device->count() > 0 ? device->as<std::string>() : "", assignments));
}

std::vector<Field> outputFields (RenderOfFocus& options)
{
    return {
        Field ("--out", &options.folder, "Output folder"),
        quietField (options.isQuiet),
        Field ("--design", &options.designFile, "Plays an existing design.json instead of a focus")
            .written ("FILE")
            .without ("focus")
            .without ("--finger"),
        Field ("--format", &options.files.format, "Format of the voltages").oneOf ({ "wav", "csv", "mat", "tfw" }),
        Field ("--no-report", &options.files.hasReport, "Writes no report.html"),
        Field ("--figures", &options.files.figures,
               "Also writes the figures of the report for print: svg, pdf (repeatable)")
            .oneOf ({ "svg", "pdf" }),
        Field ("--places", &options.placesFile, "CSV of x and y in mm: the focus at each of these places")
            .without ("--design"),
        Field ("--rank-by", &options.rankBy,
               "Number of summary.json by which several focuses are ranked in scores.csv"),
    };
}
} // namespace

void addRenderCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (renderText.name, renderText.summary);
    auto options = std::make_shared<RenderOfFocus>();
    auto all = fields (options->request);
    all.front().value = FocusSeries { &options->request.design.focus, &options->focuses };
    all.front().text = "Focus: an embedded name or a .json file; several: each into its own folder";
    append (all, outputFields (*options));
    command->callback (
        [options, command, read = addFields (*command, all)]
        {
            auto& request = options->request;

            if (options->designFile.empty())
                read();
            else
                request.made = playedDesign (*options, *command, *read.assignments);

            if (options->focuses.size() == 1 && options->placesFile.empty())
                renderOne (*options);
            else
                renderSeries (*options, *read.assignments);
        });
}
} // namespace antinode
