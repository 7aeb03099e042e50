#include <antinode_base/InputError.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_learning/FollowDrift.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

// How well a drift is followed from one idle ceramic, some minutes by hand: Docs/Design/estimation.md.
// Usage: antinode_drift_scores DEVICE SCATTER_PERCENT DRIFT_PERCENT_PER_HOUR JUMP_PERCENT WINDOWS TRIALS [FIRST_SEED
// [MOST_MODES]]
using namespace antinode;

namespace
{
constexpr double rate = 48000, window = 1, rest = 9; // Hz, s, s between windows

/** Noise that falls from 500 Hz on, on all ceramics but the last, as music would. */
Eigen::MatrixXd playedNoise (const ModalModel& model, double seconds, std::uint64_t seed)
{
    const auto samples = static_cast<Eigen::Index> (seconds * rate);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (model.actuators(), samples);
    RandomNumbers random (seed);

    for (Eigen::Index i = 0; i + 1 < voltages.rows(); ++i)
    {
        const Eigen::VectorXd white = random.normal (samples);
        double once = 0, twice = 0;

        for (Eigen::Index n = 0; n < samples; ++n)
        {
            once += 0.065 * (white[n] - once);
            twice += 0.065 * (once - twice);
            voltages (i, n) = 20 * twice;
        }
    }

    return voltages;
}

/** What the plate model, which steps from sample to sample, makes of them: 40 dB of noise, 1 % cubic. */
PlayedRecording recorded (const ModalModel& truth, const Eigen::MatrixXd& voltages, std::uint64_t seed)
{
    constexpr double cubic = 0.01, noise = 0.01;
    const auto last = truth.actuators() - 1;
    auto driven = truth;
    driven.participation.col (last).setZero();
    PlateModel plate (driven, { Reconstruction::bandLimited, rate }, truth.participation.col (last).transpose().eval());
    const auto largest = voltages.cwiseAbs().maxCoeff();
    Eigen::MatrixXd fed = Eigen::MatrixXd::Zero (voltages.rows(), voltages.cols() + plate.latencySamples());
    fed.leftCols (voltages.cols()) = voltages.array() * (1 + cubic * (voltages.array() / largest).square());
    Eigen::MatrixXd heard (1, fed.cols());
    plate.process (fed, heard);
    PlayedRecording recording { rate, voltages, heard.rightCols (voltages.cols()), {}, 0 };
    RandomNumbers random (seed);
    const auto deviation =
        noise * recording.signals.norm() / std::sqrt (static_cast<double> (recording.signals.cols()));
    recording.signals.row (0) += deviation * random.normal (recording.signals.cols()).transpose();
    recording.noise = Eigen::VectorXd::Constant (1, deviation);
    return recording;
}
} // namespace

int main (int count, char** arguments)
{
    if (count < 7)
        return 2;

    const auto number = [&] (int i) { return std::atof (arguments[i]); };
    const auto scatter = number (2) / 100, perHour = number (3) / 100, jump = number (4) / 100;
    const auto windows = std::atoi (arguments[5]), trials = std::atoi (arguments[6]);
    const auto first = count > 7 ? std::atoi (arguments[7]) : 1;
    const Eigen::Index mostModes = count > 8 ? std::atoi (arguments[8]) : 1000;
    const auto device = loadDevice (arguments[1], {});
    const auto known = solveDevice (device, {}, true);
    const auto top = known.frequencyHz (known.modes() - 1);
    const auto all = modesWithin (solveWide (device, known, std::min (1.5 * top, 0.45 * rate), true).model, rate);
    const auto learner = firstModes (all, std::min (all.modes(), mostModes));
    const auto finer = solveWide (device, known, std::min (3 * top, 0.48 * rate), true).model;
    std::printf ("%td modes known, %td followed, %td played\n", known.modes(), learner.modes(), finer.modes());
    DriftSettings settings;
    settings.spread.frequency = std::max (scatter, 1e-4);
    const auto layout = driftLayout (learner, 1);
    std::vector<Sensor> sensors { { learner.participation.col (learner.actuators() - 1).transpose() } };
    settings.spread.feedthrough = usualFeedthrough (learner, sensors);
    auto nominal = learner;
    nominal.participation.col (nominal.actuators() - 1).setZero();
    std::vector<double> commonErrors, modeErrors, jumpWindows;
    double seconds = 0;

    for (int seed = first; seed < first + trials; ++seed)
    {
        const auto start = detuned (finer, { scatter, 0.1, 0.05, 0 }, static_cast<std::uint64_t> (seed));
        auto estimate = startOfDrift (layout, settings.spread);
        int afterJump = -1, lost = 0;

        for (int w = 0; w < windows; ++w)
        {
            auto truth = start;
            const auto hasJumped = jump != 0 && w >= windows / 2;
            truth.angularFrequencies *= (1 + perHour * w * (window + rest) / 3600) * (hasJumped ? 1 + jump : 1);
            const auto voltages =
                playedNoise (truth, settings.memory + window + 0.1, static_cast<std::uint64_t> (1000 * seed + w));
            const auto recording = atLowerRate (recorded (truth, voltages, static_cast<std::uint64_t> (7 * seed + w)),
                                                highestModelled (learner));
            const auto begin = std::clock();
            auto followed = followDrift (nominal, sensors, estimate, recording, settings);
            seconds += static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
            const auto moment = momentOf (followed, layout, w * (window + rest));
            lost += followed.state == DriftState::lost;
            // What all modes share, by those that are known best.
            std::vector<double> errors;

            for (Eigen::Index k = 0; k < learner.modes(); ++k)
                if (moment.deviations[k] < 5e-5)
                    errors.push_back (
                        (1 + moment.frequencies[k]) * learner.angularFrequencies[k] / truth.angularFrequencies[k] - 1);

            const auto middle = errors.empty() ? 1.0 : median (errors);

            if (hasJumped && afterJump < 0 && followed.state == DriftState::following && std::abs (middle) < 1e-4)
                afterJump = w - windows / 2 + 1;

            if (w == windows - 1)
            {
                commonErrors.push_back (std::abs (middle));

                for (auto& error : errors)
                    error = std::abs (error);

                modeErrors.push_back (errors.empty() ? 1.0 : median (errors));
                std::printf (
                    "%4d: %zu modes within 50 ppm by themselves, median of errors %.1f ppm, of magnitudes %.1f "
                    "ppm, unexplained %.1f %%, lost %d%s%s\n",
                    seed, errors.size(), 1e6 * middle, 1e6 * modeErrors.back(), 100 * followed.unexplained, lost,
                    jump != 0 ? (", jump followed after windows: " + std::to_string (afterJump)).c_str() : "",
                    followed.reason.c_str());
                std::fflush (stdout);
            }

            estimate = afterTime (std::move (followed.estimate), layout, settings.spread, window + rest);
        }
    }

    std::printf ("%s: common %.1f ppm median, %.1f worst; a mode %.1f ppm median; %.2f s of processor time a window\n",
                 arguments[1], 1e6 * median (commonErrors),
                 1e6 * *std::max_element (commonErrors.begin(), commonErrors.end()), 1e6 * median (modeErrors),
                 seconds / (windows * trials));
}
