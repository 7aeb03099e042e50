#include "Commands.h"
#include "FieldOptions.h"
#include "Progress.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Library.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_tasks/Perform.h>

#include <cstdio>
#include <memory>
#include <optional>

namespace antinode
{
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
} // namespace antinode
