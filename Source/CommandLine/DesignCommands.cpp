#include "CommandLine.h"
#include "TaskCommand.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/TableExport.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_render/Summary.h>
#include <antinode_tasks/Field.h>
#include <antinode_tasks/Perform.h>
#include <antinode_tasks/Render.h>
#include <antinode_tasks/Tolerance.h>
#include <antinode_tasks/Tradeoffs.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

namespace antinode
{
namespace
{
struct DesignOptions
{
    ToleranceRequest request;
    std::filesystem::path folder = "antinode-out";
    bool hasTolerance = false, isTradeoff = false, isForMatlab = false, isQuiet = false;
};

void print (const DesignedFocus& designed, const FocusPower& power)
{
    const auto& result = designed.made.design;
    const auto model = ownModel (designed);
    std::printf ("%s on %s: %zu modes, captured %.4f, peak %s V of %s V\n", result.description.name.c_str(),
                 model.name.c_str(), result.controlledModes.size(), result.captured,
                 inWords (peakVoltage (result)).c_str(), inWords (result.program.voltageLimits.maxCoeff()).c_str());

    if (const auto expected = expectedError (model, result))
        std::printf ("Field error on the device: %s\n", expected->sentence.c_str());

    printPower (model, power);

    if (result.limit)
        std::printf ("%s\n", limitSentence (model, *result.limit).c_str());

    for (const auto& warning : result.warnings)
        std::printf ("Warning: %s\n", warning.c_str());
}

void runDesign (DesignOptions& options)
{
    auto& request = options.request;
    const auto designed = std::make_shared<const DesignedFocus> (design (request.design, {}));
    const auto power = designedPower (*designed);
    std::optional<DesignOnDevices> played;
    OutputFolder folder (options.folder);
    folder.write ("design.json", designFileText (*designed, power));

    if (options.isForMatlab)
        folder.write ("design.mat", encodeDesignForMatlab (designed->made.design, designedModel (designed->made.wide)));

    if (options.hasTolerance)
    {
        Progress progress (options.isQuiet);
        request.made = designed;
        request.folder = options.folder / "tolerance-draws";
        played = tolerance (request, progress.shown());
        writeTolerances (folder, *played);
    }

    folder.commit();
    std::error_code ignored;
    std::filesystem::remove_all (options.folder / "tolerance-draws", ignored);

    if (options.isQuiet)
        return;

    print (*designed, power);

    if (played)
        std::printf ("%s%s/tolerance.html\n", tolerancesInWords (*played).c_str(), options.folder.c_str());

    std::printf ("%s/design.json\n", options.folder.c_str());
}

/** All designs, or those that were finished when the user interrupted. @throws Cancelled  where there are none */
DesignTradeoff designsSoFar (const DesignOptions& options)
{
    const auto& request = options.request.design;
    Progress progress (options.isQuiet);
    progress.show (request.focus.felt ? "Designing" : "Finding the lower bound", 0);
    DesignTradeoff soFar;

    try
    {
        return designTradeoff (request,
                               [&] (const DesignTradeoff& now, double share)
                               {
                                   soFar = now;
                                   progress.show ("Designing", share,
                                                  formatted ("%zu of %zu designs", now.designs(), now.planned()));
                               });
    }
    catch (const Cancelled&)
    {
        if (soFar.designs() == 0)
            throw;

        answerInterruption();
        return soFar;
    }
}

void sweep (const DesignOptions& options)
{
    const auto tradeoff = designsSoFar (options);
    writeTradeoff (options.folder, tradeoff);

    if (! options.isQuiet)
        std::printf ("%s%s/tradeoff.html\n", tradeoffInWords (tradeoff).c_str(), options.folder.c_str());

    if (tradeoff.designs() < tradeoff.planned())
        throw Cancelled();
}
} // namespace

void printPower (const ModalModel& model, const FocusPower& power)
{
    const std::array headings { "current", "power", "amplifier" };
    const auto sentences = powerInWords (model, power);

    for (std::size_t i = 0; i < sentences.size(); ++i)
        std::printf ("  %-14s %s\n", sentences.size() == 1 ? "power" : headings[i], sentences[i].c_str());
}

void addDesignCommand (CLI::App& app)
{
    auto* command = app.add_subcommand ("design", "Computes the voltages of a focus and writes design.json");
    auto options = std::make_shared<DesignOptions>();
    auto& request = options->request;
    const std::string tolerance = "--tolerance";
    auto all = fields (request.design);
    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet),
                   Field (tolerance, &options->hasTolerance,
                          "Computes the field error on devices that differ from the model") });

    for (auto& field : fields (request.devices))
        all.push_back (field.with (tolerance));

    append (all,
            { Field ("--mat", &options->isForMatlab, "Also writes drives and allocation as design.mat"),
              Field ("--tradeoff", &options->isTradeoff,
                     "Compares all methods and growths instead: peak voltage against time in motion; of a focus with "
                     "'felt' its weights: peak voltage against felt contrast")
                  .without (tolerance)
                  .without ("--mat") });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            options->isTradeoff ? sweep (*options) : runDesign (*options);
        });
}

namespace
{
struct PerformOptions
{
    PerformRequest request;
    std::filesystem::path folder = "antinode-out";
    bool hasReport = true, hasDesign = false, isQuiet = false;
};

/** Of a recording: nothing where none was looked for. */
std::string latencyInWords (double latency)
{
    return latency > 0 ? ", came " + fixedText (latency * milli, 3) + " ms late" : std::string();
}

void printPerformed (const PerformOptions& options, const PerformedWaveforms& performed)
{
    const auto& description = performed.design.description;
    std::printf ("%s on %s\n", description.name.c_str(), performed.judge.name.c_str());
    std::printf ("  %-20s %9s %11s %12s %10s %10s\n", "finger", "wanted/um", "reached/um", "error/dB", "device/dB",
                 "felt/dB SL");

    for (std::size_t p = 0; p < performed.scores.fingers.size(); ++p)
    {
        const auto& score = performed.scores.fingers[p];
        const auto device = performed.expected.empty() ? "-" : fixedText (performed.expected[p], 1);
        std::printf ("  %-20s %9.3f %11.3f %12.1f %10s %10.1f\n", fingerName (description, p).c_str(),
                     score.wantedPeak * micro, score.reachedPeak * micro, performed.scores.suppression (p),
                     device.c_str(), performed.felt.targets[p].level);
    }

    std::printf ("  error: unwanted motion at a finger over the strongest track, %s to %s Hz\n",
                 inWords (description.band.lower).c_str(), inWords (description.band.upper).c_str());

    if (! performed.expected.empty())
        std::printf ("  device: the expected error on the device itself, by the origin of its modes\n");

    if (const auto& correction = performed.correction)
    {
        for (std::size_t i = 0; i < correction->errors.size(); ++i)
            std::printf ("  recorded pass %zu: %.1f dB at the worst finger%s\n", i + 1, correction->errors[i],
                         latencyInWords (correction->latencies[i]).c_str());

        std::printf ("  corrected: %g %% of the error of pass %zu\n", 100 * correction->gain, correction->best + 1);
    }

    if (const auto latency = performed.design.latency; latency > 0)
        std::printf ("  latency: %.2f ms from an input to its finger\n", latency * milli);

    if (performed.likeness)
        std::printf ("  tracks begin %.2f ms after the first played sample; correlation of reached and wanted: %.4f\n",
                     -performed.design.voltages.firstTime * milli, *performed.likeness);

    std::printf ("  voltages: %s\n", trackVoltsInWords (performed).c_str());
    printPower (performed.judge, performed.power);

    if (const auto& tolerance = performed.tolerance)
        std::printf ("%s\n%s", drawnInWords (tolerance->options).c_str(),
                     toleranceInWords (description, *tolerance).c_str());

    if (performed.undone && performed.undone->lateness > 0)
        std::printf ("  lags of ceramics: %s\n", lagsInWords (*performed.undone).c_str());

    for (const auto& warning : performed.design.warnings)
        std::printf ("  warning: %s\n", warning.c_str());

    std::printf ("Waveforms, voltages and sounds: %s/%s\n", options.folder.c_str(),
                 options.hasReport ? "report.html" : "summary.json");
}
} // namespace

void addPerformCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (performText.name, performText.summary);
    auto options = std::make_shared<PerformOptions>();
    auto all = fields (options->request);
    append (all,
            { Field ("--out", &options->folder, "Output folder"),
              Field ("--design", &options->hasDesign,
                     "Also writes design.json: the voltages as the plug-in and render --design play them"),
              Field ("--played", &options->request.played,
                     "Evaluates voltages recorded elsewhere, as in a host: WAV, one channel per ceramic, 1.0 = full "
                     "scale")
                  .written ("FILE")
                  .without ("--latency-ms")
                  .without ("--correct")
                  .without ("--tolerance")
                  .without ("--rate")
                  .without ("--design"),
              Field ("--no-report", &options->hasReport, "Writes no report.html"), quietField (options->isQuiet) });
    command->callback (
        [options, read = addFields (*command, all)]
        {
            read();
            Progress progress (options->isQuiet);
            const auto& request = options->request;
            const auto performed = perform (request, progress.shown());
            const auto own =
                options->hasDesign ? std::optional (solveDevice (request.device, {}, request.usesCache)) : std::nullopt;
            writePerformed (options->folder, performed, { options->hasReport, own ? &*own : nullptr });

            if (! options->isQuiet)
                printPerformed (*options, performed);
        });
}

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
