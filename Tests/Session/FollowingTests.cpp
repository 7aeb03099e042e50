#include "PlayedSession.h"
#include "Support/FollowedWindows.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_focus/Detuning.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_session/KnownDrift.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

using namespace antinode;

namespace
{
constexpr double followedRate = 48000;
constexpr int listening = 7; // the last of eight ceramics

/** The demonstrator's staple, off its model, while it is played: an idle ceramic's current comes back 3 ms later. */
struct DriftingStaple
{
    explicit DriftingStaple (double drift, double scatter = 5e-4)
        : nominal (solveDevice (test::deviceNamed ("staple").description, {}, true)),
          truth (detuned (nominal, { scatter, 0.02, 0.01, 0 }, 3))
    {
        move (drift);
    }

    void move (double drift)
    {
        truth.angularFrequencies *= 1 + drift;
        const Eigen::MatrixXd heard = truth.participation.col (listening).transpose();
        // What moves already rings out at its frequencies.
        ringing = std::exchange (
            plate, std::make_unique<PlateModel> (truth, Playback { Reconstruction::bandLimited, followedRate }, heard));
    }

    /** One block. @param volts  8 x N */
    Eigen::RowVectorXd hear (const Eigen::MatrixXd& volts)
    {
        Eigen::MatrixXd signal (1, volts.cols());
        plate->process (volts, signal);
        Eigen::MatrixXd rings = Eigen::MatrixXd::Zero (1, volts.cols());

        if (ringing != nullptr)
            ringing->process (Eigen::MatrixXd::Zero (volts.rows(), volts.cols()), rings);

        return signal + rings + noise * random.normal (volts.cols()).transpose();
    }

    ModalModel nominal, truth;
    std::unique_ptr<PlateModel> plate, ringing;
    RandomNumbers random { 5 };
    double noise = 0;
};

/** A session, the device and the cable between them. */
struct FollowedPlay
{
    static constexpr int block = 256, late = 144, windowSamples = 24576; // samples

    explicit FollowedPlay (double drift, double scatter = 5e-4) : device (drift, scatter)
    {
        played.prepare (followedRate);
        FollowingSettings following;
        following.sensor = FollowingSensor::ceramicCurrent;
        following.ceramic = listening;
        played.session.following().setSettings (following);
        played.session.waitUntilSettled (std::array { note });
    }

    /** Plays for some seconds, five foci in each, as quickly as windows are followed.
        @param spoil  what becomes of the sensor's block */
    void play (double seconds, const std::function<void (Eigen::RowVectorXd&)>& spoil = {})
    {
        for (int done = 0; done < static_cast<int> (seconds * followedRate); done += block)
        {
            if (clock % 9600 < block)
                events = { note };

            clock += block;
            playBlock (spoil);

            if (clock % windowSamples < block)
                windows.await (static_cast<double> (clock) / followedRate, [this] { return status(); });
        }
    }

    void playBlock (const std::function<void (Eigen::RowVectorXd&)>& spoil)
    {
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> channels (10, block);
        std::vector<double*> pointers;
        Eigen::RowVectorXd sensor = cable.leftCols (block);

        if (spoil)
            spoil (sensor);

        for (Eigen::Index i = 0; i < channels.rows(); ++i)
            pointers.push_back (&channels (i, 0));

        // As in a host: the sensor comes in where the first ceramic goes out.
        channels.row (0) = sensor;
        played.session.process<double> (
            { {}, std::span (pointers).first (8), std::span (pointers).last (2), block, events, pointers[0] }, {});
        events.clear();
        const Eigen::MatrixXd volts = device.nominal.fullScaleVoltage * channels.topRows (8);
        largest = volts.cwiseAbs().rowwise().maxCoeff().cwiseMax (largest);
        isFinite = isFinite && volts.allFinite();
        const auto signal = device.hear (volts);
        energy += signal.squaredNorm();
        const Eigen::RowVectorXd heard = scale * signal;
        Eigen::RowVectorXd next (cable.size());
        next << cable.rightCols (cable.size() - block), heard;
        cable = next;
    }

    FollowingStatus status() const { return *played.session.following().status(); }

    /** Waits for what windows that were played say. */
    bool becomes (FollowingState state)
    {
        for (int i = 0; i < 60; ++i)
        {
            if (status().state == state)
                return true;

            play (0.25);
        }

        return false;
    }

    static constexpr FocusEvent note { 0, FocusEventKind::trigger, 60, 1 };

    test::PlayedSession played;
    DriftingStaple device;
    double scale = -40; // the wires are swapped
    Eigen::RowVectorXd cable = Eigen::RowVectorXd::Zero (late + block);
    Eigen::VectorXd largest = Eigen::VectorXd::Zero (8);
    bool isFinite = true;
    std::vector<FocusEvent> events;
    std::int64_t clock = 0;
    test::FollowedWindows windows;
    double energy = 0; // of what was heard
};
} // namespace

TEST_CASE ("While foci play, the drift is found and followed, and foci are designed for it", "[session][following]")
{
    FollowedPlay play (0.004);
    REQUIRE (play.becomes (FollowingState::following));
    play.play (3);
    const auto status = play.status();
    INFO (status.reason);
    REQUIRE_FALSE (status.trace.empty());
    CHECK (status.trace.back().common == Approx (0.004).margin (1e-3));
    int known = 0;

    for (Eigen::Index k = 0; k < status.changes.size(); ++k)
        if (status.deviations[k] < 1e-4)
        {
            const auto truth = play.device.truth.angularFrequencies[k] / play.device.nominal.angularFrequencies[k] - 1;
            CHECK (status.changes[k] == Approx (truth).margin (5 * status.deviations[k]));
            ++known;
        }

    CHECK (known > 5);
    CHECK (status.delay == Approx ((FollowedPlay::late + FollowedPlay::block) / followedRate).margin (0.003));
    CHECK (status.redesigns > 0);

    // An idle ceramic is not driven.
    CHECK (play.largest[listening] == 0);
    CHECK (play.largest.head (listening).minCoeff() > 0);
    CHECK ((play.largest.array() <= voltageLimits (play.device.nominal).array()).all());
}

TEST_CASE ("Frozen, nothing is learnt, and reset, the model counts again until a drift is given back",
           "[session][following]")
{
    FollowedPlay play (0.004);
    auto& session = play.played.session;
    REQUIRE (play.becomes (FollowingState::following));
    auto settings = session.following().settings();
    settings.isFrozen = true;
    session.following().setSettings (settings);
    REQUIRE (play.becomes (FollowingState::frozen));
    const auto known = session.following().drift();
    REQUIRE (known != nullptr);
    const auto moments = play.status().trace.size();
    play.device.move (0.01);
    play.play (2);
    CHECK (play.status().trace.size() == moments);
    CHECK (session.following().drift() == known);
    session.following().setDrift (nullptr);
    play.play (0.5);
    CHECK (session.following().drift() == nullptr);
    session.following().setDrift (known);
    play.play (0.5);
    CHECK (session.following().drift() == known);
}

TEST_CASE ("A jump of one percent is recovered or declared", "[session][following]")
{
    FollowedPlay play (0.001);
    REQUIRE (play.becomes (FollowingState::following));
    play.play (2);
    play.device.move (0.01);
    const auto before = play.status().trace.size();
    // A window that the jump divides may be taken for another one: those behind it are whole.
    const auto isRecovered = [&play]
    {
        const auto newest = play.status();
        return newest.state == FollowingState::following && std::abs (newest.trace.back().common - 0.011) < 1e-3;
    };
    play.play (4);

    for (int i = 0; i < 8 && ! isRecovered(); ++i)
        play.play (0.5);

    const auto status = play.status();
    INFO (status.reason);
    REQUIRE (status.trace.size() > before);
    CHECK (status.state == FollowingState::following);
    CHECK (status.trace.back().common == Approx (0.011).margin (1e-3));
}

TEST_CASE ("Whatever the sensor says, outputs stay finite and within the limits, and the reason is said",
           "[session][following]")
{
    FollowedPlay play (0.002);
    REQUIRE (play.becomes (FollowingState::following));
    const auto spoil = GENERATE (0, 1, 2, 3, 4);
    RandomNumbers random (9);
    const auto spoiled = [&] (Eigen::RowVectorXd& sensor)
    {
        switch (spoil)
        {
            case 0:
                sensor.setZero();
                break;
            case 1:
                sensor = (1e3 * sensor).cwiseMax (-1).cwiseMin (1);
                break;
            case 2:
                sensor.setConstant (std::numeric_limits<double>::quiet_NaN());
                break;
            case 3:
                sensor = 0.1 * random.normal (sensor.size()).transpose();
                break;
            default:
                sensor[7] = std::numeric_limits<double>::infinity();
        }
    };
    play.play (1.5, spoiled); // Windows from before are still on their way.
    const auto known = play.played.session.following().drift();
    play.play (2, spoiled);
    const auto status = play.status();
    CHECK (status.state == FollowingState::lost);
    CHECK_FALSE (status.reason.empty());
    CHECK (play.isFinite);
    CHECK ((play.largest.array() <= voltageLimits (play.device.nominal).array()).all());
    CHECK ((play.played.session.following().drift()->sensed.estimate.values == known->sensed.estimate.values));
}

// By hand, two minutes: Docs/Design/estimation.md.
TEST_CASE ("A drift of one percent an hour while foci play", "[.following-drift]")
{
    constexpr double perSecond = 0.01 / 3600, step = 3; // s
    FollowedPlay play (0.001, 0.001);
    play.play (1);
    play.device.noise = 0.01 * std::sqrt (play.energy / followedRate); // 40 dB, from now on
    REQUIRE (play.becomes (FollowingState::following));
    std::vector<double> errors;

    for (int i = 0; i < 60; ++i)
    {
        play.play (step);
        const auto status = play.status();
        double worst = 0;
        int known = 0;

        for (Eigen::Index k = 0; k < status.changes.size(); ++k)
            if (status.deviations[k] < 5e-5)
            {
                const auto truth =
                    play.device.truth.angularFrequencies[k] / play.device.nominal.angularFrequencies[k] - 1;
                errors.push_back (std::abs (status.changes[k] - truth));
                worst = std::max (worst, errors.back());
                ++known;
            }

        std::printf ("%4.0f s: %+.4f %%, %d modes known to 50 ppm, worst off by %.0f ppm, %d redesigns %s\n", step * i,
                     100 * status.trace.back().common, known, 1e6 * worst, status.redesigns, status.reason.c_str());
        play.device.move (perSecond * step);
    }

    std::sort (errors.begin(), errors.end());
    REQUIRE (errors.size() > 100);
    std::printf ("off by %.1f ppm in the median, %.1f ppm at 95 %%\n", 1e6 * errors[errors.size() / 2],
                 1e6 * errors[errors.size() * 95 / 100]);
    CHECK (errors[errors.size() / 2] < 5e-5);
}

TEST_CASE ("What cannot be followed is said in a sentence", "[session][following]")
{
    test::PlayedSession played;
    played.prepare (followedRate);
    FollowingSettings following;
    following.sensor = FollowingSensor::ceramicCurrent;
    following.ceramic = 8;
    played.session.following().setSettings (following);

    while (played.session.following().status()->state != FollowingState::impossible)
        std::this_thread::sleep_for (std::chrono::milliseconds (5));

    CHECK (played.session.following().status()->reason == "following: ceramic 9 is not on the device; allowed: 1 to 8");
    played.session.following().setSettings ({});

    while (played.session.following().status()->state != FollowingState::off)
        std::this_thread::sleep_for (std::chrono::milliseconds (5));

    CHECK (played.session.following().status()->state == FollowingState::off);
}
