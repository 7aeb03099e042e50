#include "MeasuredBeam.h"

#include <antinode_engine/PlateModel.h>

#include <Support/ErrorText.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double perfect = 300; // dB

/** The velocity at the listening place by the plate model, which steps through time. */
Eigen::VectorXd steppedThrough (const ModalModel& model, const Eigen::MatrixXd& voltages, double rate)
{
    PlateModel plate (model, { Reconstruction::bandLimited, rate }, shapesAt (model, listeningPlace, 0));
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero (voltages.rows(), voltages.cols() + plate.latencySamples());
    padded.leftCols (voltages.cols()) = voltages;
    Eigen::MatrixXd velocities (1, padded.cols());
    plate.process (padded, velocities);
    return velocities.rightCols (voltages.cols()).transpose();
}
} // namespace

TEST_CASE ("The simulated bench does what the plate model does step by step in time")
{
    auto settings = shortSettings (ExcitationSignal::multisine, 2);
    settings.highestFrequency = 3000; // Where the plate model's interpolation is flat.
    settings.periods = 1;
    const auto excitation = testExcitation (settings);
    const auto model = benchBeam();
    SimulatedBenchSettings bench;
    bench.signalToNoise = perfect;
    bench.delay = 0;

    const Eigen::VectorXd recorded = recordRun (excitation, model, 1, bench).sensors.row (0);
    const Eigen::MatrixXd voltages = playedRun (excitation, 1, 1).topRows (2);
    const auto stepped = steppedThrough (model, voltages, settings.sampleRate);
    CHECK ((recorded - stepped).norm() < 1e-5 * stepped.norm());
}

TEST_CASE ("The noise of the simulated bench is as strong as asked for, white, and the same for the same seed")
{
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::multisine, 2));
    const auto model = benchBeam();
    SimulatedBenchSettings quiet, noisy;
    quiet.signalToNoise = perfect;
    noisy.signalToNoise = 40;
    const Eigen::VectorXd clean = recordRun (excitation, model, 0, quiet).sensors.row (0);
    const Eigen::VectorXd noise = recordRun (excitation, model, 0, noisy).sensors.row (0).transpose() - clean;
    CHECK (20 * std::log10 (clean.norm() / noise.norm()) == Approx (40).margin (0.1));

    const auto neighbours = noise.head (noise.size() - 1).dot (noise.tail (noise.size() - 1)) / noise.squaredNorm();
    CHECK (std::abs (neighbours) < 0.02);
    CHECK (recordRun (excitation, model, 0, noisy).sensors == recordRun (excitation, model, 0, noisy).sensors);
    noisy.seed = 2;
    CHECK (recordRun (excitation, model, 0, noisy).sensors.row (0).transpose() - clean != noise);
}

TEST_CASE ("The simulated bench names what it cannot do")
{
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::multisine, 2));
    SimulatedBenchSettings bench;
    bench.delay = -1;
    CHECK_THAT (errorText ([&] { recordRun (excitation, benchBeam(), 0, bench); }),
                Catch::Contains ("allowed: 0 to 200 ms"));
    bench = {};
    bench.cubic = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT (errorText ([&] { recordRun (excitation, benchBeam(), 0, bench); }),
                Catch::Contains ("cubic distortion is out of range; allowed: -20 to 20 %"));
    CHECK_THAT (errorText ([&] { recordRun (excitation, sineBeam (3, 3), 0, {}); }),
                Catch::Contains ("the voltages of all its ceramics"));
}
