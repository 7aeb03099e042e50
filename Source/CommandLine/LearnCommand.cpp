#include "Commands.h"
#include "CommonOptions.h"
#include "LearnFiles.h"
#include "LearnSetup.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_learning/LearningVerdict.h>
#include <antinode_library/Inputs.h>
#include <antinode_render/LagOutcome.h>
#include <antinode_responses/PointsFile.h>

#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
/** The places of the velocity sensors, 0 x 2 where there are none. */
Eigen::MatrixX2d sensorPlaces (const LearnOptions& options)
{
    return options.pointsFile.empty() ? Eigen::MatrixX2d (0, 2) : readPointsFile (options.pointsFile);
}

void print (const LearnOptions& options, const LearningSetup& setup, const LearntFocus& learnt,
            const LearningSettings& settings)
{
    std::printf ("%s on %s\n", setup.focus.name.c_str(), setup.nominal.model.name.c_str());
    std::printf ("  %-6s %22s %34s\n", "pass", "field error (estimated)", "not predicted, of the noise (nominal)");

    for (std::size_t i = 0; i < learnt.passes.size(); ++i)
        std::printf ("  %-6zu %21.2f %% %24.1f (%.1f)\n", i + 1, 100 * learnt.passes[i].estimatedError,
                     learnt.passes[i].surprise, learnt.passes[i].nominalSurprise);

    if (! learnt.passes.empty())
        std::printf ("  not explained in the end: %.2g %% of the signals, %.2f of the noise\n",
                     100 * learnt.learnt.unexplained, learnt.learnt.residual);

    if (learnt.learnt.heldBackBefore > 0)
        std::printf ("  sensors held back: %.2g %% not predicted by the others, %.2g %% by the device as it was\n",
                     100 * learnt.learnt.heldBack, 100 * learnt.learnt.heldBackBefore);

    if (! learnt.refusal.empty())
        std::printf ("  %s%s\n", keptInWords (learnt).c_str(), learnt.refusal.c_str());

    if (const auto warning = warningOf (learnt); ! warning.empty())
        std::printf ("  %s\n", warning.c_str());

    if (needsLagFilters (setup.nominal.model))
        std::printf ("  lags of ceramics: %s\n", lagsInWords (learntOutputs (learnt, settings)).c_str());

    std::printf ("Next voltages and what was learnt: %s/voltages.wav, report.html\n", options.folder.c_str());
}

void learn (const LearnOptions& options)
{
    if (options.isSimulated + options.isPlayed + ! options.recorded.empty() > 1)
        throw InputError ("learn", "is given more than one of --simulate, --play and --recorded; allowed: one of them");

    checkAssignments (options.assignments);
    const auto device =
        loadDevice (deviceFor (LibraryKind::focus, { options.focus }, options.device, usualDevice, options.assignments),
                    options.assignments);
    Progress progress (options.isQuiet);
    progress.show ("Modes of the device", 0);
    const auto setup =
        learningSetup (device, loadFocus (options.focus, options.assignments), sensorPlaces (options), options);
    const auto settings = learningSettings (options);
    const auto learnt =
        learnFocus (setup.nominal, setup.focus, setup.sensors, setup.deviations, passesOf (options, setup), settings,
                    [&] (double share) { progress.show ("Learning", share); });
    writeLearnt (options.folder, setup, learnt, settings);

    if (! options.isQuiet)
        print (options, setup, learnt, settings);
}

void addPlayOptions (CLI::App& command, LearnOptions& options)
{
    command.add_flag ("--simulate", options.isSimulated,
                      "Plays on a simulated bench whose device deviates as these options say");
    command.add_flag (
        "--play", options.isPlayed,
        "Plays and records through an audio device: ceramics from output 1 on, sensors as --sensor-input says");
    command.add_option ("--passes", options.passes, "Plays at most, with --play or --simulate")
        ->check (CLI::Range (1, 20))
        ->capture_default_str();
    command
        .add_option ("--enough-percent", options.enough,
                     "Estimated field error of a play after which no more is played, %")
        ->check (CLI::Range (0.0, 100.0))
        ->capture_default_str();
    addAudioBenchOptions (command, options.audio);
    addSensorOptions (command, options.audio.sensor);
    command
        .add_option ("--idle-ma-per-v", options.idleScale, "Current of an idle ceramic per volt at its input, mA per V")
        ->check (CLI::Range (1e-9, 1e9))
        ->capture_default_str();
}

void addSimulationOptions (CLI::App& command, LearnOptions& options)
{
    auto* const simulate = command.get_option ("--simulate");
    command.add_option ("--seed", options.bench.seed, "Seed of the simulated device and its noise")
        ->capture_default_str()
        ->needs (simulate);
    command.add_option ("--simulated-delay-ms", options.benchDelay, "Latency of the simulated bench, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str()
        ->needs (simulate);
    command.add_option ("--simulated-cubic-percent", options.benchCubic, "Cubic distortion of the simulated bench, %")
        ->check (CLI::Range (-20.0, 20.0))
        ->capture_default_str()
        ->needs (simulate);
    command.add_option ("--snr-db", options.bench.signalToNoise, "Signal-to-noise ratio of the sensors, dB")
        ->check (CLI::Range (-20.0, 300.0))
        ->capture_default_str();
}

void addDeviationOptions (CLI::App& command, LearnOptions& options)
{
    command.add_option ("--place-mm", options.place, "Standard deviation of each sensor's place along x and y, mm")
        ->check (CLI::Range (0.0, 50.0))
        ->capture_default_str();
    const auto add = [&] (const char* name, auto& value, const std::string& text)
    { return command.add_option (name, value, text)->check (CLI::Range (0.0, 50.0))->type_name ("FLOAT"); };
    const std::string bySource = " (default: by where the modes come from)";
    add ("--frequency-percent", options.frequency,
         "Standard deviation of each frequency from the device, %" + bySource);
    add ("--damping-percent", options.damping, "Standard deviation of each damping ratio, %" + bySource);
    add ("--participation-percent", options.participation, "Standard deviation of each participation, %" + bySource);
    add ("--distortion-percent", options.distortion,
         "Standard deviation of each ceramic's cubic distortion at its largest voltage, %; 0: ceramics are linear")
        ->capture_default_str();
}
} // namespace

void addLearnCommand (CLI::App& app)
{
    auto* command = app.add_subcommand (
        "learn", "Improves a focus from recordings of its plays: learns the modes, designs it again");
    auto options = std::make_shared<LearnOptions>();
    command->add_option ("focus", options->focus, "Focus: an embedded name or a .json file")->capture_default_str();
    command->add_option ("--device", options->device,
                         "Device: an embedded name or a .json file (default: the one that the focus names, else "
                         "staple)");
    command->add_option ("--sensors", options->pointsFile, "CSV of x and y, mm: the places of the velocity sensors")
        ->type_name ("POINTS.csv");
    command
        ->add_option ("--idle-ceramic", options->idleCeramics,
                      "Ceramic that is not driven and whose current is a channel after the sensors, counted from 1 "
                      "(repeatable)")
        ->allow_extra_args (false)
        ->check (CLI::Range (1, 4096));
    command
        ->add_option ("--recorded", options->recorded,
                      "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)")
        ->allow_extra_args (false)
        ->type_name ("FOLDER");
    command
        ->add_option ("--latency-ms", options->latency,
                      "Latency of the recordings, ms (default: that of the sync input, else it is looked for)")
        ->check (CLI::Range (0.0, 200.0));
    command->add_option ("--longest-latency-ms", options->longestLatency, "The longest latency that is looked for, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    addPlayOptions (*command, *options);
    addDeviationOptions (*command, *options);
    addSimulationOptions (*command, *options);
    command->add_option ("--rate", options->rate, "Sample rate, Hz")->type_name ("FLOAT")->capture_default_str();
    command->add_option ("--duration-ms", options->duration, "Length of each play, ms")
        ->check (CLI::Range (1.0, 10000.0))
        ->capture_default_str();
    command->add_option ("--out", options->folder, "Output folder")->capture_default_str();
    command
        ->add_option ("--set", options->assignments,
                      "Overrides a key, for example focus.targets.0.x_mm=24 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    addCacheFlag (*command, options->usesCache);
    command->add_flag ("--quiet", options->isQuiet, "Prints only errors");
    command->callback ([options] { learn (*options); });
}
} // namespace antinode
