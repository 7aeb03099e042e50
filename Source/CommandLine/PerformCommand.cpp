#include "Commands.h"
#include "CommonOptions.h"
#include "PerformedFiles.h"
#include "Progress.h"
#include "RecordedPasses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/Library.h>
#include <antinode_library/SkinThresholds.h>
#include <antinode_library/TrackModels.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_render/PerformedWaveforms.h>
#include <antinode_text/WaveReader.h>

#include <cstdio>
#include <memory>
#include <optional>

namespace antinode
{
namespace
{
struct PerformOptions
{
    std::string waveforms = "three-fingers", device, folder = "antinode-out", thresholdFile, played;
    double rate = 48000;       // Hz
    double latency = 0;        // ms
    double longestLatency = 0; // ms, of recordings
    std::vector<std::string> assignments, passes;
    SensorOptions sensor;
    bool hasReport = true, hasDesign = false, usesCache = true, isQuiet = false;
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

    std::printf ("  error: what a finger should not feel over the strongest track, %s to %s Hz\n",
                 inWords (description.band.lower).c_str(), inWords (description.band.upper).c_str());

    if (! performed.expected.empty())
        std::printf ("  device: the error to expect on the device itself, by where its modes come from\n");

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

/** What the voltages of a file do, 1.0 of which is the device's full scale. */
PerformedWaveforms judgePlayed (const std::string& file, const ModalModel& known, const ModalModel& judge,
                                const WaveformsDescription& description, TrackSettings settings,
                                const ShowProgress& show)
{
    const auto wave = readWaveFile (file);
    settings.sampleRate = wave.sampleRate;
    const Eigen::MatrixXd asked = judge.fullScaleVoltage * wave.samples;
    auto performed =
        judgeVoltages (known, judge, description, settings, withLags (judge, asked, wave.sampleRate), show);

    if (needsLagFilters (judge))
        performed.undone = UndoneLags { asked }; // The samples of the file stay.

    return performed;
}

std::vector<RecordedPass> readPasses (const PerformOptions& options, const ModalModel& known,
                                      const WaveformsDescription& description)
{
    return withoutLatency (readRecordedPasses (options.passes, known, description.band, options.sensor), known,
                           description, options.rate, options.longestLatency / milli);
}

void perform (const PerformOptions& options)
{
    checkAssignments (options.assignments);
    Progress progress (options.isQuiet);
    const auto show = [&] (const std::string& what, double share) { progress.show (what, share); };
    const auto description = loadWaveforms (options.waveforms, options.assignments);
    TrackSettings settings;
    settings.sampleRate = options.rate;
    settings.latency = options.latency / milli;
    settings.threshold = findSkinThreshold (options.thresholdFile);
    const auto device = loadDevice (
        deviceFor (LibraryKind::waveforms, { options.waveforms }, options.device, "glass-148x210", options.assignments),
        options.assignments);
    show ("Modes of the device", 0);
    const auto [known, judge] = trackModels (device, options.usesCache);
    const auto performed =
        options.played.empty()
            ? performWaveforms (known, judge, description, settings, show, readPasses (options, known, description))
            : judgePlayed (options.played, known, judge, description, settings, show);
    const auto own = options.hasDesign ? std::optional (solveDevice (device, {}, options.usesCache)) : std::nullopt;
    writePerformed (options.folder, performed, { options.hasReport, own ? &*own : nullptr });

    if (! options.isQuiet)
        printPerformed (options, performed);
}
} // namespace

void addPerformCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("perform", "Gives every finger its own waveform: voltages, what each feels, a report");
    auto options = std::make_shared<PerformOptions>();
    command->add_option ("waveforms", options->waveforms, "Waveforms: an embedded name or a .json file")
        ->capture_default_str();
    command->add_option ("--device", options->device,
                         "Device: an embedded name or a .json file (default: the one that the waveforms name, else "
                         "glass-148x210)");
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    auto* rate = command->add_option ("--rate", options->rate, "Sample rate, Hz");
    rate->check (CLI::Range (1000.0, 2e6))->type_name ("FLOAT")->capture_default_str();
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example waveforms.tracks.0.x_mm=24 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command->add_option ("--threshold", options->thresholdFile,
                         "CSV of Hz and um: what skin feels, in place of the built-in table");
    auto* latency = command->add_option (
        "--latency-ms", options->latency,
        "Voltages follow the tracks as live inputs, by filters with this latency, ms: for example 5");
    latency->check (CLI::Range (0.1, 100.0))->type_name ("FLOAT");
    auto* passes = command->add_option (
        "--correct", options->passes,
        "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)");
    passes->allow_extra_args (false)->type_name ("FOLDER")->excludes (latency);
    command
        ->add_option ("--longest-latency-ms", options->longestLatency,
                      "The longest latency of each recording that is looked for, ms; 0: it begins with its voltages")
        ->check (CLI::Range (0.0, 200.0))
        ->type_name ("FLOAT")
        ->needs (passes)
        ->capture_default_str();
    command
        ->add_option (
            "--played", options->played,
            "Judges voltages recorded elsewhere, as in a host: WAV, one channel per ceramic, 1.0 = full scale")
        ->type_name ("FILE")
        ->excludes (latency)
        ->excludes (passes)
        ->excludes (rate)
        ->excludes (
            command->add_flag ("--design", options->hasDesign,
                               "Also writes design.json: the voltages as the plug-in and render --design play them"));
    addSensorOptions (*command, options->sensor);
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("!--no-report", options->hasReport, "Writes no report.html");
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { perform (*options); });
}
} // namespace antinode
