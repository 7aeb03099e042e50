#include "Commands.h"
#include "CommonOptions.h"
#include "Progress.h"
#include "RenderFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_focus/LimitWords.h>
#include <antinode_reports/FocusReport.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
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
    std::string format = "wav";
    bool hasReport = true;
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

    if (options.duration)
        result.duration = *options.duration / 1000;

    for (const auto& probe : options.probes)
        result.probes.push_back (parseProbe (probe));

    return result;
}

void printSummary (const RenderedFocus& focus, const RenderCommandOptions& options)
{
    const auto& design = focus.design;
    std::printf ("%s on %s\n", design.description.name.c_str(), focus.model.name.c_str());
    std::printf ("  v-score        %.6f   (against the wanted field %.4f)\n", focus.truncatedScore.vScore,
                 focus.score.vScore);
    std::printf ("  field error    %.4f %%   (against the wanted field %.2f %%)\n",
                 100 * focus.truncatedScore.fieldError, 100 * focus.score.fieldError);
    std::printf ("  captured       %.4f by %zu of %td modes\n", design.captured, design.controlledModes.size(),
                 focus.model.modes());
    std::printf ("  peak velocity  %s mm/s\n", inWords (focus.reachedField.cwiseAbs().maxCoeff() * 1000).c_str());
    std::printf ("  peak voltage   %s V of %s V\n", inWords (focus.render.voltages.cwiseAbs().maxCoeff()).c_str(),
                 inWords (design.program.voltageLimits.maxCoeff()).c_str());

    if (design.limit)
        std::printf ("  limit          %s\n", limitSentence (focus.model, *design.limit).c_str());

    for (const auto& warning : design.warnings)
        std::printf ("  warning: %s\n", warning.c_str());

    std::printf ("Figures and scores: %s/%s\n", options.common.folder.c_str(),
                 options.hasReport ? "report.html" : "summary.json");
}

void render (const RenderCommandOptions& options)
{
    Progress progress (options.common.isQuiet);
    const auto settings = renderOptions (options);
    auto [model, design] = designFrom (options.common);
    const auto focus = renderFocus (std::move (model), std::move (design), settings,
                                    [&] (double share) { progress.show ("Rendering", share); });

    OutputFolder folder (options.common.folder);
    writeSamples (folder, focus, options.format);
    folder.write ("design.json", designToJson (focus.design, focus.model).dump (2) + "\n");
    folder.write ("summary.json", summaryToJson (focus).dump (2) + "\n");

    if (options.hasReport)
        folder.write ("report.html", renderReport (focusReport (focus)));

    folder.commit();

    if (! options.common.isQuiet)
        printSummary (focus, options);
}
} // namespace

void addRenderCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("render", "Renders a focus: voltages, velocities, scores and a report with figures");
    auto options = std::make_shared<RenderCommandOptions>();
    addCommonOptions (*command, options->common);
    command->add_option ("--probe", options->probes, "Position of a velocity probe, mm (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("X,Y");
    command->add_option ("--duration-ms", options->duration, "Rendered duration from the trigger, ms");
    command->add_option ("--block-size", options->blockSize, "Samples per block; does not affect the result")
        ->check (CLI::Range (1, 8193))
        ->capture_default_str();
    command->add_option ("--format", options->format, "Format of the voltages")
        ->check (CLI::IsMember ({ "wav", "csv", "tfw" }))
        ->capture_default_str();
    command->add_flag ("!--no-report", options->hasReport, "Writes no report.html");
    command->callback ([options] { render (*options); });
}
} // namespace antinode
