#include "LearnSetup.h"

#include "CommonOptions.h"
#include "FocusOnDevice.h"
#include "IdleCeramicsOption.h"
#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_bench/PlayPasses.h>
#include <antinode_bench/SimulatedBenchPlayer.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/DriveAllocation.h>
#include <antinode_learning/UsualDeviations.h>
#include <antinode_library/Library.h>
#include <antinode_model/IdleCeramics.h>
#include <antinode_model/ShapesAtPlaces.h>

#include <memory>
#include <utility>

namespace antinode
{
namespace
{
/** What sensors hear of each mode's velocity, N x N_m: mode shapes, and by reciprocity the currents of idle ceramics.
 */
Eigen::MatrixXd heardShapes (const ModalModel& model, const Eigen::MatrixX2d& places, const std::vector<int>& idle)
{
    Eigen::MatrixXd shapes (places.rows() + std::ssize (idle), model.modes());
    shapes.topRows (places.rows()) = shapesAtPlaces (model, places);

    for (std::size_t i = 0; i < idle.size(); ++i)
        shapes.row (places.rows() + static_cast<Eigen::Index> (i)) = model.participation.col (idle[i] - 1).transpose();

    return shapes;
}

PassPlaySettings playSettings (const LearnOptions& options)
{
    PassPlaySettings settings;
    settings.sampleRate = options.rate;
    settings.longestDelay = options.longestLatency / 1000;
    settings.usesSync = options.audio.syncInput > 0;
    return settings;
}

/** The delay of a pass where it was said. */
void setDelay (PlayedRecording& recording, const LearnOptions& options)
{
    if (options.latency)
    {
        recording.delay = *options.latency / 1000;
        recording.delaySpan = 0;
    }
}

PassPlayer recordedPasses (const LearnOptions& options, const LearningSetup& setup)
{
    return [&] (const Eigen::MatrixXd&, int pass)
    {
        return withNoiseAndLatency (readPlayedRecording (options.recorded[static_cast<std::size_t> (pass)],
                                                         setup.nominal.model, std::ssize (setup.sensors),
                                                         options.audio.sensor),
                                    options);
    };
}

/** A bench whose device deviates as the options say. */
std::unique_ptr<Bench> simulatedLearningBench (const LearnOptions& options, const LearningSetup& setup)
{
    const auto& deviations = setup.deviations;
    const DetuningSpread spread { deviations.frequencies[0], deviations.dampings[0], deviations.participation[0],
                                  deviations.drift };
    const auto truth = detuned (setup.device, spread, options.bench.seed);
    auto bench = options.bench;
    bench.delay = options.benchDelay / 1000;
    bench.cubic = options.benchCubic / 100;
    bench.seed *= 1000;
    return std::make_unique<SimulatedBenchPlayer> (withoutDrive (truth, options.idleCeramics),
                                                   heardShapes (truth, setup.places, options.idleCeramics), bench);
}

/** How far the device may be from its model: as the options say, else by where its modes come from. */
ModeSpread deviationsOf (const LearnOptions& options, const ModalModel& model)
{
    auto deviations = usualDeviations (model);
    const auto say = [] (Eigen::VectorXd& values, const std::optional<double>& percent)
    {
        if (percent)
            values.setConstant (*percent / 100);
    };
    say (deviations.frequencies, options.frequency);
    say (deviations.dampings, options.damping);
    say (deviations.participation, options.participation);
    deviations.distortion = options.distortion / 100;
    return deviations;
}

/** An audio device; currents of idle ceramics have a scale of their own. */
PassPlayer audioPasses (const LearnOptions& options, const LearningSetup& setup)
{
    const auto wired = std::ssize (options.audio.sensorInputs), wanted = std::ssize (setup.sensors);

    if (wired != wanted)
        throw InputError ("--sensor-input", "is given " + std::to_string (wired)
                                                + " times; allowed: " + std::to_string (wanted) + ", once per sensor");

    const std::shared_ptr<Bench> bench = openAudioBench (options.audio, setup.nominal.model, options.rate);
    auto play = playPasses (*bench, wanted, playSettings (options));
    return [&options, bench, play = std::move (play)] (const Eigen::MatrixXd& voltages, int pass)
    {
        auto recording = play (voltages, pass);
        const auto idle = std::ssize (options.idleCeramics);
        const auto scale = options.idleScale / options.audio.sensor.sensitivity;
        recording.signals.bottomRows (idle) *= scale;
        recording.noise.tail (idle) *= scale;
        setDelay (recording, options);
        return recording;
    };
}
} // namespace

PlayedRecording withNoiseAndLatency (PlayedRecording recording, const LearnOptions& options)
{
    recording.noise = noiseOfRecording (recording.signals, options.bench.signalToNoise);
    recording.delaySpan = options.longestLatency / 1000;
    setDelay (recording, options);
    return recording;
}

PassPlayer undoingLags (PassPlayer play, const LearningSetup& setup, double sampleRate)
{
    const auto& device = setup.nominal.model;

    if (! needsLagFilters (device))
        return play;

    const auto limits = voltageLimits (device, setup.focus.allocation);
    return [play = std::move (play), &device, limits, sampleRate] (const Eigen::MatrixXd& voltages, int pass)
    {
        auto recording = play (withLagsUndone (device, voltages, limits, sampleRate).voltages, pass);
        recording.voltages = withLags (device, recording.voltages, sampleRate);
        return recording;
    };
}

LearningSetup learningSetup (const DeviceDescription& device, FocusDescription focus, Eigen::MatrixX2d places,
                             const LearnOptions& options)
{
    checkSampleRate (options.rate);
    const auto known = solveDevice (device, {}, options.usesCache);
    auto wide = wideOf (device, known, { Reconstruction::bandLimited, options.rate }, options.usesCache);
    checkIdleCeramics (options.idleCeramics, known);
    LearningSetup setup { device, wide.model, wide, std::move (focus), std::move (places), {}, {} };
    checkKindOfPlaces (known, setup.focus);
    checkKindOfPlaces (known, setup.places, "sensor");
    setup.nominal.model = withoutDrive (setup.device, options.idleCeramics);

    setup.deviations = deviationsOf (options, setup.nominal.model);

    for (Eigen::Index m = 0; m < setup.places.rows(); ++m)
        setup.sensors.push_back (
            sensorAt (setup.device, setup.places (m, 0), setup.places (m, 1), options.place / 1000));

    for (const auto idle : options.idleCeramics)
        setup.sensors.push_back (idleCeramic (setup.device, idle - 1, setup.deviations.participation[0]));

    if (setup.sensors.empty())
        throw InputError ("learn", "has no sensor; allowed: --sensors, --idle-ceramic or both");

    return setup;
}

PassPlayer passesOf (const LearnOptions& options, const LearningSetup& setup)
{
    if (options.isPlayed)
        return undoingLags (audioPasses (options, setup), setup, options.rate);

    if (! options.isSimulated)
        return recordedPasses (options, setup);

    const std::shared_ptr<Bench> bench = simulatedLearningBench (options, setup);
    auto play = playPasses (*bench, std::ssize (setup.sensors), playSettings (options));
    return [bench, play = std::move (play)] (const Eigen::MatrixXd& voltages, int pass)
    { return play (voltages, pass); };
}

LearningSettings learningSettings (const LearnOptions& options)
{
    LearningSettings settings { options.rate, options.duration / 1000, options.passes, options.enough / 100 };

    if (! options.isSimulated && ! options.isPlayed)
    {
        settings.passes = static_cast<int> (options.recorded.size());
        settings.enough = 0; // What was recorded is used.
    }

    return settings;
}
} // namespace antinode
