#include <antinode_base/InputError.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/Library.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_numerics/Median.h>
#include <antinode_numerics/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

// The table of learning from plays, some minutes by hand: Docs/Decisions/0110-learning-from-plays.md.
// Environment: KNOWS_DELAY=1 (else it is looked for up to 30 ms), CUBIC, BEYOND.
// Usage: antinode_learning_scores DEVICE FOCUS SCATTER_PERCENT SENSORS IDLE PASSES TRIALS [FIRST_SEED]
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

double relative (const Surface& surface, const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return std::sqrt (surface.areas.dot ((a - b).cwiseAbs2()) / surface.areas.dot (b.cwiseAbs2()));
}
} // namespace

int main (int count, char** arguments)
{
    if (count < 8)
        return 2;

    const std::string deviceName = arguments[1], focusName = arguments[2];
    const double scatter = std::atof (arguments[3]) / 100;
    const int sensorCount = std::atoi (arguments[4]), idle = std::atoi (arguments[5]),
              passes = std::atoi (arguments[6]), trials = std::atoi (arguments[7]),
              first = count > 8 ? std::atoi (arguments[8]) : 1;
    const double cubic = std::getenv ("CUBIC") ? std::atof (std::getenv ("CUBIC")) : 0.01;
    const bool knowsDelay = std::getenv ("KNOWS_DELAY") != nullptr;
    const double beyond = std::getenv ("BEYOND") ? std::atof (std::getenv ("BEYOND")) : 3.5;
    const auto device = loadDevice (deviceName, {});
    const auto known = solveDevice (device, {}, true);
    Case of { solveWide (device, known, 2.5 * known.frequencyHz (known.modes() - 1), true),
              {},
              loadFocus (focusName, {}) };
    of.finer = solveWide (device, known, beyond * known.frequencyHz (known.modes() - 1), true).model;
    std::printf ("%td modes known, %td in the learner's model, %td played\n", known.modes(), of.nominal.model.modes(),
                 of.finer.modes());
    const auto deviations = sameSpread (of.nominal.model.modes(), scatter, 0.1, 0.05);
    std::vector<double> before, after, seconds;
    int worse = 0, rejected = 0;

    for (int seed = first; seed < first + trials; ++seed)
    {
        const auto truth = detuned (of.finer, { scatter, scatter > 1e-6 ? 0.1 : 0, scatter > 1e-6 ? 0.05 : 0, 0 },
                                    static_cast<std::uint64_t> (seed));
        RandomNumbers random (static_cast<std::uint64_t> (seed) + 1000);
        std::vector<Sensor> sensors;
        Eigen::MatrixXd heard (sensorCount + idle, truth.modes());

        for (int m = 0; m < sensorCount; ++m)
        {
            const auto& surface = of.nominal.model.surface;
            const auto x = surface.xMinimum + (0.05 + 0.9 * random.uniform()) * (surface.xMaximum - surface.xMinimum);
            const auto y = surface.yMinimum + (0.05 + 0.9 * random.uniform()) * (surface.yMaximum - surface.yMinimum);
            sensors.push_back ({ shapesAt (of.nominal.model, x, y), 0 });
            heard.row (m) = shapesAt (truth, x, y);
        }

        auto idleModel = of.nominal;
        auto idleTruth = truth;

        if (idle > 0)
        {
            const auto last = truth.actuators() - 1;
            sensors.push_back ({ of.nominal.model.participation.col (last).transpose(), 0.05 });
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
            const auto learnt = learnFocus (idleModel, of.focus, sensors, deviations, play, settings);
            const auto spent = static_cast<double> (std::clock() - begun) / CLOCKS_PER_SEC - played;
            const auto exact = designWithin ({ idleTruth, of.nominal.known, {} }, of.focus,
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
