#include "DriftingBeam.h"

#include <antinode_learning/FollowWindow.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double length = 1.3; // s, of a window with what was played before it

DriftSensor idleCeramic (const DriftingBeam& beam, SensorQuantity quantity = SensorQuantity::rate)
{
    return { beam.nominal.participation.col (idle).transpose(), quantity, true };
}

DriftSettings usual()
{
    DriftSettings settings;
    settings.spread.damping = 0.05;
    return settings;
}

/** As it comes through an interface: some samples later, by another scale. */
PlayedRecording throughInterface (PlayedRecording recording, Eigen::Index late, double scale)
{
    Eigen::MatrixXd signals = Eigen::MatrixXd::Zero (1, recording.signals.cols());
    signals.rightCols (recording.signals.cols() - late) =
        scale * recording.signals.leftCols (recording.signals.cols() - late);
    recording.signals = signals;
    recording.noise = {};
    return recording;
}

/** By how much frequencies are off that are said to be known to 30 ppm: each, and what they share. */
struct Errors
{
    double worst = 0, common = 0;
};

Errors errorsOf (const DriftingBeam& beam, const DriftEstimate& estimate)
{
    Errors errors;
    int count = 0;

    for (Eigen::Index k = 0; k < knownModes; ++k)
        if (estimate.deviation (k) < 3e-5)
        {
            const auto error =
                beam.nominal.angularFrequencies[k] * std::exp (estimate.values[k]) / beam.truth.angularFrequencies[k]
                - 1;
            errors.worst = std::max (errors.worst, std::abs (error));
            errors.common += error;
            ++count;
        }

    REQUIRE (count > 2);
    errors.common = std::abs (errors.common / count);
    return errors;
}

void checkFollowed (const DriftingBeam& beam, const DriftEstimate& estimate)
{
    const auto errors = errorsOf (beam, estimate);
    CHECK (errors.common < 5e-5);
    CHECK (errors.worst < 1e-4);
}

/** Several windows, each of its own noise. */
SensedDrift followed (DriftingBeam& beam, SensedDrift drift, int windows, Eigen::Index late, double scale,
                      SensorQuantity quantity = SensorQuantity::rate)
{
    const auto settings = usual();

    for (int i = 0; i < windows; ++i)
    {
        beam.seed += 1;
        const auto recording =
            throughInterface (beam.recordAll (length, 20, quantity == SensorQuantity::amount), late, scale);
        auto window = followWindow (followedModes (beam.nominal, driftRate), idleCeramic (beam, quantity), drift,
                                    recording, settings);
        INFO (window.followed.reason);
        REQUIRE (window.followed.state == DriftState::following);
        drift = std::move (window.drift);
    }

    return drift;
}

SensedDrift nothingKnown (const DriftingBeam& beam)
{
    return startOfFollowing (driftLayout (beam.nominal, 1), usual().spread);
}
/** The delay is found in a window of what is heard 10 ms after it is played, of which nothing is known before. */
FollowedWindow checkFound (const DriftingBeam& beam, const Eigen::MatrixXd& voltages)
{
    constexpr Eigen::Index late = 241; // samples
    auto recording = beam.hear (voltages);
    const auto level = recording.signals.cwiseAbs().maxCoeff();
    recording = throughInterface (std::move (recording), late, 0.2 / level);
    auto window = followWindow (followedModes (beam.nominal, driftRate), idleCeramic (beam), nothingKnown (beam),
                                recording, usual());
    INFO (window.followed.reason);
    REQUIRE (window.followed.state == DriftState::following);
    CHECK (window.drift.delay == Approx (static_cast<double> (late) / driftRate).margin (2e-5));
    return window;
}
} // namespace

TEST_CASE ("A sensor of unknown delay, scale and sign is found, and the drift followed to 50 ppm",
           "[learning][following]")
{
    const auto scale = GENERATE (-3.0, 0.2);
    DriftingBeam beam (0.004, 0.001);
    const Eigen::Index late = 241; // 10 ms
    const auto level = beam.recordAll (0.2).signals.cwiseAbs().maxCoeff();
    const auto drift = followed (beam, nothingKnown (beam), 3, late, scale / (20 * level));
    CHECK (drift.delay == Approx (static_cast<double> (late) / driftRate).margin (2e-6));
    CHECK (drift.scale * 20 * level == Approx (scale).epsilon (0.1));
    checkFollowed (beam, drift.estimate);
    CHECK (drift.estimate.deviation (2) < 3e-5);
}

TEST_CASE ("What is played again and again is not taken for a delay of its period", "[learning][following]")
{
    constexpr Eigen::Index period = 4800; // samples: .2 s
    DriftingBeam beam (0.004, 0.001);
    const auto once = beam.recordAll (0.05).voltages;
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (once.rows(), static_cast<Eigen::Index> (length * driftRate));

    const auto phase = GENERATE (0, 1000, 2000, 3000, 4000);

    for (Eigen::Index begin = phase; begin + once.cols() < voltages.cols(); begin += period)
        voltages.middleCols (begin, once.cols()) = once;

    checkFound (beam, voltages);
}

// One mode alone looks almost the same a part of its period later, on a device with another drift.
TEST_CASE ("Where foci ring in one mode, the delay is not taken for another part of its period",
           "[learning][following]")
{
    constexpr double period = 0.2, centre = 0.05; // s
    const auto [drift, mode] = GENERATE (std::pair (-0.006, 4), std::pair (-0.002, 3), std::pair (0.002, 5));
    DriftingBeam beam (drift, 0.001);
    const auto omega = beam.nominal.angularFrequencies[mode], width = 12 / omega;
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (5, static_cast<Eigen::Index> (length * driftRate));

    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        const auto time = std::fmod (static_cast<double> (n) / driftRate, period) - centre;
        voltages.col (n).head (idle) =
            Eigen::Vector4d (20, 10, 5, -7) * std::sin (omega * time) * std::exp (-0.5 * std::pow (time / width, 2));
    }

    CHECK (checkFound (beam, voltages).followed.unexplained < 0.01);
}

TEST_CASE ("The charge of an idle ceramic tells what its current tells", "[learning][following]")
{
    DriftingBeam beam (0.004, 0.001);
    const auto level = beam.recordAll (0.2, 20, true).signals.cwiseAbs().maxCoeff();
    const auto drift = followed (beam, nothingKnown (beam), 3, 100, 0.2 / level, SensorQuantity::amount);
    checkFollowed (beam, drift.estimate);
    CHECK (drift.estimate.deviation (2) < 3e-5);
}

TEST_CASE ("A drift of one percent an hour is followed to 50 ppm, window by window", "[learning][following]")
{
    constexpr double perSecond = 0.01 / 3600, pause = 30;
    DriftingBeam beam (0, 0.001);
    const auto settings = usual();
    const auto layout = driftLayout (beam.nominal, 1);
    const auto level = beam.recordAll (0.2).signals.cwiseAbs().maxCoeff();
    auto drift = followed (beam, nothingKnown (beam), 1, 60, 0.2 / level);

    for (int i = 0; i < 6; ++i)
    {
        beam.truth.angularFrequencies *= 1 + perSecond * pause;
        drift.estimate = afterTime (std::move (drift.estimate), layout, settings.spread, pause);
        drift = followed (beam, std::move (drift), 1, 60, 0.2 / level);
        checkFollowed (beam, drift.estimate);
    }

    // What no mode tells by itself follows the others.
    CHECK (std::abs (frequencyChanges (drift.estimate, layout, knownModes + 2)[knownModes + 1]
                     - drift.estimate.values.head (knownModes).mean())
           < 1e-3);
}

TEST_CASE ("A jump of one percent is followed from the first whole window on", "[learning][following]")
{
    DriftingBeam beam (0, 0.0005);
    const auto level = beam.recordAll (0.2).signals.cwiseAbs().maxCoeff();
    auto drift = followed (beam, nothingKnown (beam), 2, 60, 0.2 / level);
    beam.truth.angularFrequencies *= 1.01;
    drift = followed (beam, std::move (drift), 2, 60, 0.2 / level);
    checkFollowed (beam, drift.estimate);
    CHECK (drift.estimate.values[2] == Approx (std::log (1.01)).margin (2e-3));
}

TEST_CASE ("Where the delay changes, the sensor is found again", "[learning][following]")
{
    DriftingBeam beam (0.001, 0.0005);
    const auto level = beam.recordAll (0.2).signals.cwiseAbs().maxCoeff();
    auto drift = followed (beam, nothingKnown (beam), 1, 60, 0.2 / level);
    const auto later = throughInterface (beam.recordAll (length), 200, 0.2 / level);
    int lost = 0;

    for (; lost < 6; ++lost)
    {
        auto window = followWindow (followedModes (beam.nominal, driftRate), idleCeramic (beam), drift, later, usual());
        drift = std::move (window.drift);

        if (window.followed.state == DriftState::following)
            break;

        CHECK_FALSE (window.followed.reason.empty());
    }

    CHECK (lost == 3);
    CHECK (drift.delay == Approx (200 / driftRate).margin (2e-6));
    checkFollowed (beam, drift.estimate);
}

TEST_CASE ("Sensors that are unplugged, clipped, noisy, not finite or others teach nothing, and are said",
           "[learning][following]")
{
    DriftingBeam beam (0.002, 0.0005);
    const auto level = beam.recordAll (0.2).signals.cwiseAbs().maxCoeff();
    const auto known = followed (beam, nothingKnown (beam), 1, 60, 0.2 / level);
    const auto recording = throughInterface (beam.recordAll (length), 60, 0.2 / level);
    RandomNumbers random (5);
    const auto reasonOf = [&] (const std::function<void (Eigen::MatrixXd&)>& spoil)
    {
        auto broken = recording;
        spoil (broken.signals);
        auto drift = known;
        std::string reason;

        // Also after the sensor is searched for again.
        for (int i = 0; i < 5; ++i)
        {
            const auto window =
                followWindow (followedModes (beam.nominal, driftRate), idleCeramic (beam), drift, broken, usual());
            CHECK (window.followed.state == DriftState::lost);
            CHECK ((window.drift.estimate.values == known.estimate.values));
            CHECK (window.drift.scale == known.scale);
            drift = window.drift;
            reason = window.followed.reason;
        }

        return reason;
    };
    CHECK (reasonOf ([] (Eigen::MatrixXd& s) { s.setZero(); }).find ("does not hear") != std::string::npos);
    CHECK (reasonOf ([] (Eigen::MatrixXd& s) { s = (20 * s).cwiseMin (1.0).cwiseMax (-1.0); })
           == "The sensor's signal is clipped.");
    CHECK (reasonOf ([] (Eigen::MatrixXd& s) { s (0, 99) = std::numeric_limits<double>::infinity(); })
           == "The sensor's signal is not finite.");
    CHECK_FALSE (
        reasonOf ([&] (Eigen::MatrixXd& s) { s.row (0) = 0.1 * random.normal (s.cols()).transpose(); }).empty());
    CHECK_FALSE (reasonOf (
                     [&] (Eigen::MatrixXd& s)
                     {
                         DriftingBeam other (0.3, 0.1, 77);
                         s = throughInterface (other.recordAll (length), 60, 0.2 / level).signals;
                     })
                     .empty());
}
