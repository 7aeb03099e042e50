#include "Commands.h"
#include "CommonOptions.h"
#include "FocusOnDevice.h"
#include "LearnFiles.h"
#include "Progress.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_focus/Detuning.h>
#include <antinode_library/Inputs.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_model/ShapesAtPlaces.h>
#include <antinode_responses/PointsFile.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace antinode
{
namespace
{
constexpr double percent = 100;

struct LearnOptions
{
    std::string focus = "demonstrator", device, folder = "antinode-learnt", pointsFile;
    std::vector<std::string> assignments, recorded;
    SensorOptions sensor;
    int idleCeramic = 0; // counted from 1; 0: none
    int passes = 4;
    double rate = 96000, duration = 250, latency = 0;        // Hz, ms, ms
    double frequency = 0.5, damping = 10, participation = 5; // %
    SimulatedBenchSettings bench;
    double benchDelay = 1.234567, benchCubic = 0; // ms, %
    bool isSimulated = false, usesCache = true, isQuiet = false;
};

/** What is learnt on. */
struct LearningSetup
{
    WideModel nominal;
    FocusDescription focus;
    Eigen::MatrixX2d places;
    std::vector<Sensor> sensors;
    ModeSpread deviations;
};

/** The signals of an idle ceramic per modal velocity, by reciprocity: its current. */
Eigen::RowVectorXd idleShapes (const ModalModel& model, int ceramic)
{
    return model.participation.col (ceramic - 1).transpose();
}

LearningSetup setupFor (const LearnOptions& options)
{
    checkAssignments (options.assignments);
    checkSampleRate (options.rate);
    const auto device =
        loadDevice (deviceFor (LibraryKind::focus, { options.focus }, options.device, usualDevice, options.assignments),
                    options.assignments);
    const auto known = solveDevice (device, {}, options.usesCache);
    LearningSetup setup { wideOf (device, known, { Reconstruction::bandLimited, options.rate }, options.usesCache),
                          loadFocus (options.focus, options.assignments),
                          readPointsFile (options.pointsFile),
                          {},
                          {} };
    checkKindOfPlaces (known, setup.focus);
    const auto shapes = shapesAtPlaces (setup.nominal.model, setup.places);

    for (Eigen::Index m = 0; m < shapes.rows(); ++m)
        setup.sensors.push_back ({ shapes.row (m), 0 });

    if (options.idleCeramic > known.actuators())
        throw InputError ("--idle-ceramic", "is " + std::to_string (options.idleCeramic) + "; allowed: 1 to "
                                                + std::to_string (known.actuators()));

    if (options.idleCeramic > 0)
    {
        setup.sensors.push_back (
            { idleShapes (setup.nominal.model, options.idleCeramic), options.participation / percent });
        setup.nominal.model.participation.col (options.idleCeramic - 1).setZero();
    }

    setup.deviations = sameSpread (setup.nominal.model.modes(), options.frequency / percent, options.damping / percent,
                                   options.participation / percent);
    return setup;
}

PassPlayer recordedBench (const LearnOptions& options, const LearningSetup& setup)
{
    return [&] (const Eigen::MatrixXd&, int pass)
    {
        auto recording = readPlayedRecording (options.recorded[static_cast<std::size_t> (pass)], setup.nominal.model,
                                              static_cast<Eigen::Index> (setup.sensors.size()), options.sensor);
        recording.noise = noiseOfRecording (recording.signals, options.bench.signalToNoise);
        recording.delay = options.latency / 1000;
        return recording;
    };
}

/** A bench whose device deviates as the options say. */
PassPlayer simulatedBench (const LearnOptions& options, const LearningSetup& setup)
{
    const DetuningSpread spread { options.frequency / percent, options.damping / percent,
                                  options.participation / percent, 0 };
    auto truth = std::make_shared<ModalModel> (detuned (setup.nominal.model, spread, options.bench.seed));
    auto heard = std::make_shared<Eigen::MatrixXd> (static_cast<Eigen::Index> (setup.sensors.size()), truth->modes());
    heard->topRows (setup.places.rows()) = shapesAtPlaces (*truth, setup.places);

    if (options.idleCeramic > 0)
        heard->bottomRows (1) = setup.sensors.back().shapes;

    return [&options, truth, heard] (const Eigen::MatrixXd& voltages, int pass)
    {
        auto bench = options.bench;
        bench.sampleRate = options.rate;
        bench.delay = options.benchDelay / 1000;
        bench.cubic = options.benchCubic / percent;
        bench.seed = 1000 * options.bench.seed + static_cast<std::uint64_t> (pass);
        const auto recorded = simulateBench (*truth, *heard, voltages, Eigen::VectorXd::Ones (voltages.cols()), bench);
        return PlayedRecording { options.rate, voltages, recorded.sensors,
                                 noiseOfRecording (recorded.sensors, bench.signalToNoise), bench.delay };
    };
}

void print (const LearnOptions& options, const LearningSetup& setup, const LearntFocus& learnt)
{
    std::printf ("%s on %s\n", setup.focus.name.c_str(), setup.nominal.model.name.c_str());
    std::printf ("  %-6s %22s %34s\n", "pass", "field error (estimated)", "not predicted, of the noise (nominal)");

    for (std::size_t i = 0; i < learnt.passes.size(); ++i)
        std::printf ("  %-6zu %21.2f %% %24.1f (%.1f)\n", i + 1, percent * learnt.passes[i].estimatedError,
                     learnt.passes[i].surprise, learnt.passes[i].nominalSurprise);

    if (! learnt.passes.empty())
        std::printf ("  not explained in the end: %.2g %% of the signals, %.2f of the noise\n",
                     percent * learnt.learnt.unexplained, learnt.learnt.residual);

    if (! learnt.refusal.empty())
        std::printf ("  Nothing is changed. %s\n", learnt.refusal.c_str());

    std::printf ("Next voltages and what was learnt: %s/voltages.wav, learnt.csv\n", options.folder.c_str());
}

void learn (const LearnOptions& options)
{
    if (options.isSimulated && ! options.recorded.empty())
        throw InputError ("--simulate", "is given with --recorded; allowed: one of them");

    Progress progress (options.isQuiet);
    progress.show ("Modes of the device", 0);
    const auto setup = setupFor (options);
    LearningSettings settings { options.rate, options.duration / 1000,
                                options.isSimulated ? options.passes : static_cast<int> (options.recorded.size()) };
    const auto learnt =
        learnFocus (setup.nominal, setup.focus, setup.sensors, setup.deviations,
                    options.isSimulated ? simulatedBench (options, setup) : recordedBench (options, setup), settings,
                    [&] (double share) { progress.show ("Learning", share); });
    writeLearnt (options.folder, learnt, setup.nominal, setup.deviations, settings);

    if (! options.isQuiet)
        print (options, setup, learnt);
}

void addBenchOptions (CLI::App& command, LearnOptions& options)
{
    auto* const simulate = command.add_flag ("--simulate", options.isSimulated,
                                             "Plays on a simulated bench whose device deviates as these options say");
    command.add_option ("--passes", options.passes, "Plays on the simulated bench")
        ->check (CLI::Range (1, 20))
        ->capture_default_str()
        ->needs (simulate);
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
    const auto add = [&] (const char* name, double& value, const char* text)
    { command.add_option (name, value, text)->check (CLI::Range (0.0, 50.0))->capture_default_str(); };
    add ("--frequency-percent", options.frequency, "Standard deviation of each frequency from the device, %");
    add ("--damping-percent", options.damping, "Standard deviation of each damping ratio, %");
    add ("--participation-percent", options.participation, "Standard deviation of each participation, %");
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
        ->required()
        ->type_name ("POINTS.csv");
    command
        ->add_option ("--idle-ceramic", options->idleCeramic,
                      "Ceramic that is not driven and whose current is the last channel, counted from 1; 0: none")
        ->check (CLI::Range (0, 4096))
        ->capture_default_str();
    command
        ->add_option ("--recorded", options->recorded,
                      "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)")
        ->allow_extra_args (false)
        ->type_name ("FOLDER");
    command->add_option ("--latency-ms", options->latency, "Latency of the recordings, ms")
        ->check (CLI::Range (0.0, 200.0))
        ->capture_default_str();
    addSensorOptions (*command, options->sensor);
    addDeviationOptions (*command, *options);
    addBenchOptions (*command, *options);
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
