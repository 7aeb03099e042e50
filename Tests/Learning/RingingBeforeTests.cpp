#include <antinode_learning/DriftProblem.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double rate = 4000, memory = 0.5; // Hz, s
constexpr Eigen::Index samples = 2000;

/** Two modes of 40 Hz, Q = 50, and 900 Hz, Q = 20: after half a second 28 % and 2e-31 are left. */
ModalModel slowAndFast()
{
    ModalModel model;
    model.angularFrequencies = 2 * std::numbers::pi * Eigen::Vector2d (40, 900);
    model.dampingRatios = Eigen::Vector2d (0.01, 0.025);
    return model;
}

/** What a mode does once nothing drives it. */
Eigen::VectorXd freeDecay (const ModalModel& model, Eigen::Index mode, double phase)
{
    const auto omega = model.angularFrequencies[mode], ratio = model.dampingRatios[mode];
    Eigen::VectorXd decay (samples);

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto time = static_cast<double> (n) / rate;
        decay[n] = std::exp (-ratio * omega * time) * std::cos (omega * std::sqrt (1 - ratio * ratio) * time + phase);
    }

    return decay;
}
} // namespace

TEST_CASE ("What a slow mode still does from before is taken out, at any phase, and nothing else", "[learning][drift]")
{
    const auto model = slowAndFast();
    const RingingBefore ringing (model, rate, memory, samples);
    Eigen::MatrixXd signals (samples, 3);
    signals << freeDecay (model, 0, 0.3), freeDecay (model, 0, 2), freeDecay (model, 1, 0.3);
    const Eigen::MatrixXd before = signals;
    ringing.takeOutOf (signals);
    CHECK (signals.leftCols (2).norm() < 1e-10 * before.leftCols (2).norm());
    CHECK ((signals.col (2) - before.col (2)).norm() < 0.05 * before.col (2).norm());

    const Eigen::MatrixXd once = signals;
    ringing.takeOutOf (signals);
    CHECK ((signals - once).norm() < 1e-12 * before.norm());
}

TEST_CASE ("Modes that have decayed before a window leave it as it is", "[learning][drift]")
{
    const auto model = slowAndFast();
    const RingingBefore ringing (model, rate, 10 * memory, samples);
    Eigen::MatrixXd signals = freeDecay (model, 0, 1);
    const Eigen::MatrixXd before = signals;
    ringing.takeOutOf (signals);
    CHECK (signals == before);
}
