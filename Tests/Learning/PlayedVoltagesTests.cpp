#include "LearningBench.h"

#include <antinode_learning/PlayedVoltages.h>

#include <catch2/catch.hpp>

#include <cmath>

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
