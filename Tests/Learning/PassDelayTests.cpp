#include "Support/ErrorText.h"

#include <antinode_learning/RecordingDelays.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double rate = 48000;

/** Two points that ring at frequencies of their own, so much later: 2 x samples. */
Eigen::MatrixXd ringing (double latency, Eigen::Index samples)
{
    Eigen::MatrixXd signals (2, samples);

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto time = static_cast<double> (n) / rate - latency - 0.005;
        const auto burst = std::exp (-std::pow (time / 0.001, 2));
        signals (0, n) = burst * std::cos (2 * std::numbers::pi * 700 * time);
        signals (1, n) = 0.1 * burst * std::cos (2 * std::numbers::pi * 450 * time);
    }

    return signals;
}
} // namespace

TEST_CASE ("Signals that come late are moved to where they are expected", "[learning]")
{
    constexpr Eigen::Index samples = 4800;
    const auto latency = GENERATE (0.0, 0.002, 0.01234567, 0.0199);
    RandomNumbers random (1);
    const Eigen::MatrixXd late = ringing (latency, samples) + 1e-3 * random.normal (2 * samples).reshaped (2, samples);
    const auto aligned = alignedWith (late, ringing (0, 1200), rate, 0.03);
    CHECK (aligned.delay == Approx (latency).margin (1e-6));
    REQUIRE (aligned.signals.cols() == samples);
    CHECK ((aligned.signals - ringing (0, samples)).leftCols (3600).cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE ("A recording that is silent or has other channels is not aligned", "[learning]")
{
    const auto signals = ringing (0, 1200);
    CHECK (errorText ([&] { alignedWith (0 * signals, signals, rate, 0.03); }).find ("is silent") != std::string::npos);
    CHECK (errorText ([&] { alignedWith (signals.topRows (1), signals, rate, 0.03); }).find ("channels")
           != std::string::npos);
}
