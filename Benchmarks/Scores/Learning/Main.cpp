#include <antinode_base/InputError.h>
#include <antinode_base/System.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/ModeWeighing.h>
#include <antinode_identification/Comparison.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/ModeSpread.h>
#include <antinode_learning/Retuning.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <numeric>
#include <string>

// Learning from plays, some minutes by hand: Docs/Results.md, Docs/Design/estimation.md.
// Environment: KNOWS_DELAY=1 (else it is looked for up to 30 ms), CUBIC, RETUNE=1: after one measurement and retune,
// UNSURE=1: by what `antinode learn` takes for unknown of shapes at sensors, gains and mixtures of modes,
// REACH and BEYOND: highest frequency of the learner's model and of the bench's, by the highest known one. Usage:
// antinode_learning_scores DEVICE FOCUS SCATTER_PERCENT SENSORS IDLE PASSES TRIALS [FIRST_SEED]
using namespace antinode;

namespace
{
struct Case
{
    WideModel nominal; ///< What the learner knows.
    ModalModel finer;  ///< With modes beyond these.
    FocusDescription focus;
};

Eigen::MatrixXd distorted (Eigen::MatrixXd voltages, double cubic)
{
    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        if (const auto largest = voltages.row (i).cwiseAbs().maxCoeff(); largest > 0)
            voltages.row (i).array() *= 1 + cubic * (voltages.row (i).array() / largest).square();

    return voltages;
}

/** The field at the focus of a program on a plate whose ceramics distort. */
Eigen::VectorXd fieldOf (const ModalModel& truth, const VoltageProgram& program, double cubic)
{
    const Playback playback { Reconstruction::bandLimited, 96000 };
    const RenderSettings settings { playback, program.focusTime + 0.002, 512,
                                    Eigen::MatrixXd (0, truth.coordinates()) };
    const auto render = renderOffline (truth, program, settings);
    const auto voltages = distorted (render.voltages.leftCols (render.focusSample + 1), cubic);
    PlateModel plate (truth, playback, Eigen::MatrixXd (0, truth.coordinates()));
    Eigen::MatrixXd fed = Eigen::MatrixXd::Zero (voltages.rows(), render.voltages.cols());
    fed = distorted (render.voltages, cubic);
    Eigen::MatrixXd velocities (truth.coordinates(), fed.cols());
    plate.processModes (fed, velocities);
    return truth.shapes * velocities.col (render.focusSample + plate.latencySamples());
}

/** One measurement at points: responses of all ceramics with noise 40 dB below each channel's RMS. */
FrequencyResponses measured (const ModalModel& truth, const Eigen::MatrixX2d& points, const Eigen::MatrixXd& shapes,
                             RandomNumbers& random)
{
    constexpr double step = 2, highest = 24000, noise = 0.01; // Hz, Hz, share
    constexpr auto lines = static_cast<Eigen::Index> (highest / step);
    FrequencyResponses responses;
    responses.frequencies = step * Eigen::VectorXd::LinSpaced (lines, 1, static_cast<double> (lines));
    responses.points = points;
    Eigen::MatrixXcd factors (lines, truth.modes());

    for (Eigen::Index k = 0; k < truth.modes(); ++k)
        for (Eigen::Index n = 0; n < lines; ++n)
        {
            const auto omega = 2 * std::numbers::pi * responses.frequencies[n], own = truth.angularFrequencies[k];
            factors (n, k) =
                std::complex<double> (0, omega)
                / std::complex<double> (own * own - omega * omega, 2 * truth.dampingRatios[k] * own * omega);
        }

    for (Eigen::Index i = 0; i < truth.actuators(); ++i)
    {
        responses.references.push_back ({ truth.ceramics[static_cast<std::size_t> (i)].name, {} });
        Eigen::MatrixXcd values =
            factors * (truth.participation.col (i).asDiagonal() * shapes.transpose()).cast<std::complex<double>>();

        for (Eigen::Index p = 0; p < values.cols(); ++p)
        {
            const auto deviation = noise * values.col (p).norm() / std::sqrt (2.0 * static_cast<double> (lines));
            values.col (p).real() += deviation * random.normal (lines);
            values.col (p).imag() += deviation * random.normal (lines);
        }

        responses.values.push_back (std::move (values));
    }

    return responses;
}

/** The learner's model after one measurement, and what is known of it then. */
void retuneOnce (WideModel& nominal, ModeSpread& deviations, const FrequencyResponses& responses,
                 const KnownSpread& spread)
{
    const auto begun = std::clock();
    const auto retuned = retune (nominal.model, responses, spread);
    const auto found = std::count (retuned.found.begin(), retuned.found.end(), true);
    std::printf ("retuned: %td of %td modes found, %.1f dB, %.1f s\n", found, nominal.model.modes(),
                 retuned.reconstructionError, static_cast<double> (std::clock() - begun) / CLOCKS_PER_SEC);
    // What was found is said in the order of before.
    const Eigen::VectorXd moved = nominal.model.angularFrequencies.array() * (1 + retuned.frequencyChanges.array());
    std::vector<Eigen::Index> order (static_cast<std::size_t> (moved.size()));
    std::iota (order.begin(), order.end(), 0);
    std::sort (order.begin(), order.end(), [&] (auto one, auto other) { return moved[one] < moved[other]; });
    nominal.model = retuned.model;
    // Errors of a model are not noise, which alone retune knows: frequencies, dampings and participations were up to
    // 1e-4, 1 % and 1 % off.
    deviations.frequencies = retuned.frequencyDeviations (order).cwiseMax (2e-5);
    deviations.dampings = retuned.dampingDeviations (order).cwiseMax (5e-3);
    deviations.participation = retuned.participationDeviations (order).cwiseMax (0.005);
}

double relative (const Surface& surface, const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return std::sqrt (surface.areas.dot ((a - b).cwiseAbs2()) / surface.areas.dot (b.cwiseAbs2()));
}
} // namespace

int main (int count, char** arguments)
{
    if (count < 8 || std::atoi (arguments[6]) < 1)
        return 2;

    keepFreedMemory();
    const std::string deviceName = arguments[1], focusName = arguments[2];
    const double scatter = std::atof (arguments[3]) / 100;
    const int sensorCount = std::atoi (arguments[4]), idle = std::atoi (arguments[5]),
              passes = std::atoi (arguments[6]), trials = std::atoi (arguments[7]),
              first = count > 8 ? std::atoi (arguments[8]) : 1;
    const double cubic = std::getenv ("CUBIC") ? std::atof (std::getenv ("CUBIC")) : 0.01;
    const bool retunes = std::getenv ("RETUNE") != nullptr;
    const bool isUnsure = std::getenv ("UNSURE") != nullptr;
    const bool knowsDelay = std::getenv ("KNOWS_DELAY") != nullptr;
    const double beyond = std::getenv ("BEYOND") ? std::atof (std::getenv ("BEYOND")) : 3.5,
                 reach = std::getenv ("REACH") ? std::atof (std::getenv ("REACH")) : 2.5;
    const auto device = loadDevice (deviceName, {});
    const auto designed = solveDevice (device, {}, true);
    Case of { solveWide (device, designed, reach * designed.frequencyHz (designed.modes() - 1), true),
              {},
              loadFocus (focusName, {}) };
    of.finer = solveWide (device, designed, beyond * designed.frequencyHz (designed.modes() - 1), true).model;
    std::printf ("%td modes known, %td in the learner's model, %td played\n", designed.modes(),
                 of.nominal.model.modes(), of.finer.modes());
    const auto deviations =
        isUnsure ? usualDeviations (of.nominal.model) : sameSpread (of.nominal.model.modes(), scatter, 0.1, 0.05);
    std::vector<double> before, after, seconds;
    int worse = 0, rejected = 0;

    for (int seed = first; seed < first + trials; ++seed)
    {
        auto truth = detuned (of.finer, { scatter, scatter > 1e-6 ? 0.1 : 0, scatter > 1e-6 ? 0.05 : 0, 0 },
                              static_cast<std::uint64_t> (seed));

        // As retune orders what it finds: else the exact design would be one for other modes.
        if (retunes)
            truth = ascending (std::move (truth));

        RandomNumbers random (static_cast<std::uint64_t> (seed) + 1000);
        std::vector<Sensor> sensors;
        Eigen::MatrixXd heard (sensorCount + idle, truth.modes());
        Eigen::MatrixX2d points (sensorCount, 2);
        auto nominal = of.nominal;
        auto known = deviations;

        for (int m = 0; m < sensorCount; ++m)
        {
            const auto& surface = of.nominal.model.surface;
            const auto x = surface.xMinimum + (0.05 + 0.9 * random.uniform()) * (surface.xMaximum - surface.xMinimum);
            const auto y = surface.yMinimum + (0.05 + 0.9 * random.uniform()) * (surface.yMaximum - surface.yMinimum);
            points.row (m) << x, y;
            heard.row (m) = shapesAt (truth, x, y);
        }

        if (retunes)
            retuneOnce (nominal, known, measured (truth, points, heard.topRows (sensorCount), random),
                        { scatter, 0.1, 0.05, 0.003 });

        for (int m = 0; m < sensorCount; ++m)
            sensors.push_back (isUnsure ? sensorAt (nominal.model, points (m, 0), points (m, 1), 0.002)
                                        : Sensor { shapesAt (nominal.model, points (m, 0), points (m, 1)) });

        auto idleModel = nominal;
        auto idleTruth = truth;

        if (idle > 0)
        {
            const auto last = truth.actuators() - 1;
            sensors.push_back (idleCeramic (nominal.model, last, 0.05));
            heard.row (sensorCount) = truth.participation.col (last).transpose();
            // An idle ceramic is given no voltage.
            idleModel.model.participation.col (last).setZero();
            idleTruth.participation.col (last).setZero();
        }

        double played = 0; // s of processor time, of the bench
        const auto play = [&] (const Eigen::MatrixXd& voltages, int pass)
        {
            const auto begun = std::clock();
            SimulatedBenchSettings bench;
            bench.seed = static_cast<std::uint64_t> (seed * 100 + pass);
            bench.delay = 0.002 + 0.018 * random.uniform();
            bench.cubic = cubic;
            const auto recorded =
                simulateBench (idleTruth, heard, voltages, Eigen::VectorXd::Ones (voltages.cols()), bench);
            PlayedRecording recording { bench.sampleRate, voltages, recorded.sensors, {}, 0, 0 };
            recording.noise =
                recorded.sensors.rowwise().norm() * 0.01 / std::sqrt (static_cast<double> (voltages.cols()));
            played += static_cast<double> (std::clock() - begun) / CLOCKS_PER_SEC;

            if (knowsDelay)
                recording.delay = bench.delay + 5e-6 * random.normal (2)[0]; // as a sync channel tells it
            else
                recording.delaySpan = 0.03;

            return recording;
        };

        try
        {
            LearningSettings settings;
            settings.passes = passes;
            const auto begun = std::clock();
            const auto learnt = learnFocus (idleModel, of.focus, sensors, known, play, settings);
            const auto spent = static_cast<double> (std::clock() - begun) / CLOCKS_PER_SEC - played;
            // The same focus: another number of modes would be another field.
            const auto same = withModesOf (of.focus, learnt.passes.front().design);
            const auto exact = designWithin ({ idleTruth, of.nominal.known, {} }, same,
                                             { Reconstruction::bandLimited, 96000 }, DesignExtent::compared);
            const auto wanted = fieldOf (idleTruth, exact.program, 0);
            std::printf ("%4d:", seed);

            for (const auto& pass : learnt.passes)
                std::printf (" %.2f (%.2f, %.1f<%.1f)",
                             100 * relative (truth.surface, fieldOf (idleTruth, pass.design.program, cubic), wanted),
                             100 * pass.estimatedError, pass.surprise, pass.nominalSurprise);

            const auto start =
                relative (truth.surface, fieldOf (idleTruth, learnt.passes.front().design.program, cubic), wanted);
            const auto end = relative (truth.surface, fieldOf (idleTruth, learnt.design.program, cubic), wanted);
            std::printf (" -> %.2f %%, residual %.2f, %.1f s%s\n", 100 * end, learnt.learnt.residual, spent,
                         learnt.refusal.empty() ? "" : (" refused: " + learnt.refusal).c_str());
            std::fflush (stdout);
            seconds.push_back (spent);
            before.push_back (start);
            after.push_back (end);
            worse += end > start;
            rejected += ! learnt.refusal.empty();
        }
        catch (const InputError& error)
        {
            std::printf ("%4d: %s\n", seed, error.what());
        }
    }

    if (! after.empty())
        std::printf (
            "%s: start %.2f %% median, end %.2f %% median, %.2f %% worst, %d worse, %d refused of %zu; %.1f s each\n",
            focusName.c_str(), 100 * median (before), 100 * median (after),
            100 * *std::max_element (after.begin(), after.end()), worse, rejected, after.size(), median (seconds));
}
