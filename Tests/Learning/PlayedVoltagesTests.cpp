#include "LearningBench.h"

#include <antinode_learning/PlayedVoltages.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("A mode under band-limited voltages moves as the plate model says, which steps through time", "[learning]")
{
    const auto model = sineBeam (knownModes, 4);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (4, 2000);

    // Bursts well below the frequencies at which the plate model's interpolation falls.
    for (Eigen::Index n = 200; n < 1200; ++n)
        for (Eigen::Index i = 0; i < 4; ++i)
            voltages (i, n) = std::pow (std::sin (3.14159265 * static_cast<double> (n - 200) / 1000), 4)
                              * std::sin (0.05 * static_cast<double> ((i + 1) * n));

    const auto own = modeVelocities (model, { voltages, benchRate }, voltages.cols());
    const auto stepped = played (model, Eigen::MatrixXd::Identity (knownModes, knownModes), voltages);
    CHECK ((own.transpose() - stepped).norm() < 1e-6 * stepped.norm());
}

// The learner summed forces at four places once, which is right below the sample rate only: a prediction by the very
// device was off by 28 % at 48 kHz.
TEST_CASE ("Modes up to far above the sample rate follow a tone as their frequency responses say", "[learning]")
{
    constexpr Eigen::Index samples = 4000, middle = 2000;
    constexpr double toneShare = 0.05; // of the sample rate
    constexpr double turn = 2 * std::numbers::pi * toneShare;
    constexpr double tone = turn * benchRate; // rad/s
    Eigen::MatrixXd voltage (1, samples);

    for (Eigen::Index n = 0; n < samples; ++n)
        voltage (0, n) = std::pow (std::sin (std::numbers::pi * static_cast<double> (n) / samples), 4)
                         * std::sin (turn * static_cast<double> (n));

    const PlayedVoltages played (voltage, benchRate);

    for (const auto rates : { 0.3, 0.9, 2.3, 11.7 })
    {
        const auto own = 2 * std::numbers::pi * rates * benchRate;
        constexpr double damping = 0.05;
        const auto motion =
            modeMotion (own, damping, played.force (Eigen::RowVectorXd::Ones (1)), benchRate, samples, false);
        const std::complex<double> response =
            std::complex<double> (0, tone) / std::complex<double> (own * own - tone * tone, 2 * damping * own * tone);
        CAPTURE (rates);

        for (Eigen::Index n = middle - 20; n < middle + 20; ++n)
        {
            const auto wanted = (response * std::polar (1.0, turn * static_cast<double> (n))).imag();
            CHECK (std::abs (motion.velocity[n] - wanted) < 1e-3 * std::abs (response));
        }
    }
}

TEST_CASE ("The changes of a mode's motion are its differences", "[learning]")
{
    RandomNumbers random (3);
    const Eigen::VectorXd force = random.normal (500 * PlayedVoltages::places);
    constexpr double omega = 3000, damping = 0.02, step = 1e-6;
    const auto motion = [&] (double frequencyChange, double dampingChange)
    { return modeMotion (omega * (1 + frequencyChange), damping * (1 + dampingChange), force, benchRate, 500, true); };
    const auto middle = motion (0, 0);
    const Eigen::VectorXd byFrequency = (motion (step, 0).velocity - motion (-step, 0).velocity) / (2 * step);
    const Eigen::VectorXd byDamping = (motion (0, step).velocity - motion (0, -step).velocity) / (2 * step);
    CHECK ((middle.byFrequency - byFrequency).norm() < 1e-6 * byFrequency.norm());
    CHECK ((middle.byDamping - byDamping).norm() < 1e-6 * byDamping.norm());
}

TEST_CASE ("What a mode does after the last voltage is what it does under voltages of zero", "[learning]")
{
    RandomNumbers random (5);
    const Eigen::VectorXd force = random.normal (300 * PlayedVoltages::places);
    Eigen::VectorXd padded = Eigen::VectorXd::Zero (4000 * PlayedVoltages::places);
    padded.head (force.size()) = force;

    // One that goes on to the end, and one that is at rest before.
    for (const auto damping : { 0.001, 0.05 })
    {
        const auto brief = modeMotion (6000, damping, force, benchRate, 4000, true);
        const auto whole = modeMotion (6000, damping, padded, benchRate, 4000, true);
        CHECK ((brief.velocity - whole.velocity).norm() < 1e-9 * whole.velocity.norm());
        CHECK ((brief.byFrequency - whole.byFrequency).norm() < 1e-7 * whole.byFrequency.norm());
        CHECK ((brief.byDamping - whole.byDamping).norm() < 1e-7 * whole.byDamping.norm());
    }

    CHECK (modeMotionUntilRest (6000, 0.05, force, benchRate, 4000, false).velocity.size() < 4000);
}
