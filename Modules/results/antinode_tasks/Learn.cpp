#include "Learn.h"

#include "DeviceChecks.h"
#include "LearnFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_bench/Bench.h>
#include <antinode_bench/PlayPasses.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/DriveAllocation.h>
#include <antinode_learning/ModeSpread.h>
#include <antinode_model/ModalModel.h>

#include <algorithm>
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

PassPlaySettings playSettings (const LearnRequest& request)
{
    PassPlaySettings settings;
    settings.sampleRate = request.sampleRate;
    settings.longestDelay = request.longestLatency;
    settings.usesSync = request.wiring.syncInput > 0;
    return settings;
}

/** The delay of a pass where it was said. */
void setDelay (PlayedRecording& recording, const LearnRequest& request)
{
    if (request.latency)
    {
        recording.delay = *request.latency;
        recording.delaySpan = 0;
    }
}

/** A recording with what is said of its noise and its latency. */
PlayedRecording withNoiseAndLatency (PlayedRecording recording, const LearnRequest& request)
{
    recording.noise = noiseOfRecording (recording.signals, request.bench.signalToNoise);
    recording.delaySpan = request.longestLatency;
    setDelay (recording, request);
    return recording;
}

/** Plays by a function. */
PassPlayer playedBy (const LearnRequest& request)
{
    return [&] (const Eigen::MatrixXd& voltages, int pass)
    {
        auto signals = request.play (voltages, pass);
        const auto samples = std::min (voltages.cols(), signals.cols());
        return withNoiseAndLatency (
            { request.sampleRate, voltages.leftCols (samples), signals.leftCols (samples), {}, 0 }, request);
    };
}

PassPlayer recordedPasses (const LearnRequest& request, const LearningSetup& setup)
{
    return [&] (const Eigen::MatrixXd&, int pass)
    {
        return withNoiseAndLatency (readPlayedRecording (request.recorded[static_cast<std::size_t> (pass)],
                                                         setup.nominal.model, std::ssize (setup.sensors),
                                                         request.wiring.sensor),
                                    request);
    };
}

/** A bench whose device deviates as the request says. */
std::unique_ptr<Bench> simulatedLearningBench (const LearnRequest& request, const LearningSetup& setup)
{
    const auto& deviations = setup.deviations;
    const DetuningSpread spread { deviations.frequencies[0], deviations.dampings[0], deviations.participation[0],
                                  deviations.drift };
    const auto truth = detuned (setup.device, spread, request.bench.seed);
    auto bench = request.bench;
    bench.seed *= 1000;
    return std::make_unique<SimulatedBenchPlayer> (withoutDrive (truth, request.idleCeramics),
                                                   heardShapes (truth, setup.places, request.idleCeramics), bench);
}

/** How far the device may be from its model: as the request says, else by where its modes come from. */
ModeSpread deviationsOf (const LearnRequest& request, const ModalModel& model)
{
    auto deviations = usualDeviations (model);
    const auto say = [] (Eigen::VectorXd& values, const std::optional<double>& value)
    {
        if (value)
            values.setConstant (*value);
    };
    say (deviations.frequencies, request.frequency);
    say (deviations.dampings, request.damping);
    say (deviations.participation, request.participation);
    deviations.distortion = request.distortion;
    return deviations;
}

/** An audio device; currents of idle ceramics have a scale of their own. */
PassPlayer audioPasses (const LearnRequest& request, const LearningSetup& setup)
{
    const auto wired = std::max<std::ptrdiff_t> (1, std::ssize (request.wiring.sensorInputs)),
               wanted = std::ssize (setup.sensors);

    if (wired != wanted)
        throw InputError ("--sensor-input", "is given " + std::to_string (wired)
                                                + " times; allowed: " + std::to_string (wanted) + ", once per sensor");

    const std::shared_ptr<Bench> bench = openAudioBench (request.wiring, setup.nominal.model, request.sampleRate);
    auto play = playPasses (*bench, wanted, playSettings (request));
    return [&request, bench, play = std::move (play)] (const Eigen::MatrixXd& voltages, int pass)
    {
        auto recording = play (voltages, pass);
        const auto idle = std::ssize (request.idleCeramics);
        const auto scale = request.idleScale / request.wiring.sensor.sensitivity;
        recording.signals.bottomRows (idle) *= scale;
        recording.noise.tail (idle) *= scale;
        setDelay (recording, request);
        return recording;
    };
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

LearningSetup learningSetup (const LearnRequest& request)
{
    const auto [known, wide, widen, playback] =
        setUp (request.device, { Reconstruction::bandLimited, request.sampleRate }, request.usesCache);
    checkIdleCeramics (request.idleCeramics, known);
    LearningSetup setup { request.device, wide.model, wide, request.focus, request.places, {}, {} };
    checkKindOfPlaces (known, setup.focus);
    checkKindOfPlaces (known, setup.places, "sensor");
    setup.nominal.model = withoutDrive (setup.device, request.idleCeramics);

    setup.deviations = deviationsOf (request, setup.nominal.model);

    for (Eigen::Index m = 0; m < setup.places.rows(); ++m)
        setup.sensors.push_back (sensorAt (setup.device, setup.places (m, 0), setup.places (m, 1), request.place));

    for (const auto idle : request.idleCeramics)
        setup.sensors.push_back (idleCeramic (setup.device, idle - 1, setup.deviations.participation[0]));

    if (setup.sensors.empty())
        throw InputError ("learn", "has no sensor; allowed: --sensors, --idle-ceramic or both");

    return setup;
}

PassPlayer passesOf (const LearnRequest& request, const LearningSetup& setup)
{
    if (request.isPlayed)
        return undoingLags (audioPasses (request, setup), setup, request.sampleRate);

    if (request.play)
        return undoingLags (playedBy (request), setup, request.sampleRate);

    if (! request.isSimulated)
        return recordedPasses (request, setup);

    const std::shared_ptr<Bench> bench = simulatedLearningBench (request, setup);
    auto play = playPasses (*bench, std::ssize (setup.sensors), playSettings (request));
    return [bench, play = std::move (play)] (const Eigen::MatrixXd& voltages, int pass)
    { return play (voltages, pass); };
}

LearningSettings learningSettings (const LearnRequest& request)
{
    LearningSettings settings { request.sampleRate, request.duration, request.passes, request.enough };

    if (! request.isSimulated && ! request.isPlayed && ! request.play)
    {
        settings.passes = static_cast<int> (request.recorded.size());
        settings.enough = 0; // What was recorded is used.
    }

    return settings;
}
} // namespace

std::vector<Field> fields (LearnRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000, millimetres = 1000;
    const std::string simulate = "--simulate";
    const auto deviation = [&] (const char* option, auto& value, const char* of)
    { return Field (option, &value, std::string ("Standard deviation of each ") + of).in (percent).within (0, 50); };
    const auto origin = "by the origin of the modes";
    std::vector<Field> all {
        focusField (request.focus),
        deviceOfFocusField (request.device),
        Field ("--sensors", &request.places, "Places of the velocity sensors").as ("sensors_mm").written ("POINTS.csv"),
        Field (
            "--idle-ceramic", &request.idleCeramics,
            "Ceramic that is not driven and whose current is a channel after the sensors, counted from 1 (repeatable)")
            .as ("idle_ceramics")
            .within (1, 4096),
        Field ("--recorded", &request.recorded,
               "Folder of an earlier pass with recorded.csv or recorded.wav in it (repeatable, in order)")
            .written ("FOLDER"),
        Field ("", &request.play,
               "Function that plays voltages (N_b x N_s, V, not to be written into) in a pass (from 0) and gives the "
               "signals of the sensors, N x samples: velocities, m/s, then currents of idle ceramics, A")
            .as ("play")
            .by ("nothing is played"),
        Field (simulate, &request.isSimulated, "Plays on a simulated bench whose device deviates as these options say"),
        Field ("--latency-ms", &request.latency, "Latency of the recordings, ms")
            .in (milliseconds)
            .within (0, 200)
            .by ("that of the sync input, else found from the signals"),
        Field ("--longest-latency-ms", &request.longestLatency, "Longest latency in the search, ms")
            .in (milliseconds)
            .within (0, 200),
        Field ("--passes", &request.passes, "Plays at most").within (1, 20),
        Field ("--enough-percent", &request.enough, "Stops after a play with this estimated field error, %")
            .in (percent)
            .within (0, 100),
        Field ("--place-mm", &request.place, "Standard deviation of each sensor's place along x and y, mm")
            .in (millimetres)
            .within (0, 50),
        deviation ("--frequency-percent", request.frequency, "frequency from the device, %").by (origin),
        deviation ("--damping-percent", request.damping, "damping ratio, %").by (origin),
        deviation ("--participation-percent", request.participation, "participation, %").by (origin),
        deviation ("--distortion-percent", request.distortion,
                   "ceramic's cubic distortion at its largest voltage, %; 0: ceramics are linear"),
        Field ("--seed", &request.bench.seed, "Seed of the simulated device and its noise")
            .within (0, 1.8446744073709552e19)
            .with (simulate),
        Field ("--simulated-delay-ms", &request.bench.delay, "Latency of the simulated bench, ms")
            .in (milliseconds)
            .within (0, 200)
            .with (simulate),
        Field ("--simulated-cubic-percent", &request.bench.cubic, "Cubic distortion of the simulated bench, %")
            .in (percent)
            .within (-20, 20)
            .with (simulate),
        Field ("--snr-db", &request.bench.signalToNoise, "Signal-to-noise ratio of the sensors, dB")
            .as ("snr_dB")
            .within (-20, 300),
        sampleRateField (request.sampleRate),
        Field ("--duration-ms", &request.duration, "Length of each play, ms").in (milliseconds).within (1, 10000),
        cacheField (request.usesCache),
    };
    append (all, fields (request.wiring.sensor));
    return all;
}

LearntDevice learn (const LearnRequest& request, const ShowProgress& show)
{
    if (request.isSimulated + request.isPlayed + ! request.recorded.empty() + (request.play != nullptr) > 1)
        throw InputError ("learn", "is given more than one of --simulate, --play and --recorded; allowed: one of them");

    if (show)
        show ("Modes of the device", 0);

    auto setup = learningSetup (request);
    const auto settings = learningSettings (request);
    auto learnt =
        learnFocus (setup.nominal, setup.focus, setup.sensors, setup.deviations, passesOf (request, setup), settings,
                    [&] (double share)
                    {
                        if (show)
                            show ("Learning", share);
                    });
    return { std::move (setup), settings, std::move (learnt) };
}
} // namespace antinode
