#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_tracks/PointResponses.h>
#include <antinode_tracks/TrackDesign.h>
#include <antinode_tracks/TrackWork.h>

#include <catch2/catch.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double bandUpper = 800; // Hz

TrackSettings settingsFor (double rate)
{
    TrackSettings settings;
    settings.sampleRate = rate;
    settings.threshold = { "flat", Eigen::Vector2d (50, 1000), Eigen::Vector2d (1e-7, 1e-7) };
    return settings;
}

WaveformsDescription twoPoints (double level)
{
    WaveformsDescription description;
    description.band = { 100, bandUpper };
    auto& track = description.tracks.emplace_back();
    track.point.x = 0.05;
    track.point.y = 0.06;
    track.events[0].signal = GaborSignal { 350, 0.01 };
    track.events[0].level = { LevelKind::displacement, level };
    auto& silent = description.silent.emplace_back();
    silent.x = 0.14;
    silent.y = 0.1;
    return description;
}

/** points x modes, s after the trigger. */
using ShapesInTime = std::function<Eigen::MatrixXd (double time)>;

/** The surface in time by steps of the trapezoidal rule on mass, damping and stiffness, fingers included: no modal
    recursion, no transform. At 16 steps a sample of 48 kHz a tone of 800 Hz is right to 4e-6. */
Eigen::MatrixXd steppedMotion (const ModalModel& model, const ShapesInTime& shapes, const std::vector<Finger>& fingers,
                               const SampledVoltages& voltages)
{
    constexpr int steps = 16;
    const auto h = 1 / voltages.playback.sampleRate / steps;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Identity (model.modes(), model.modes());
    Eigen::MatrixXd damping = (2 * model.dampingRatios.cwiseProduct (model.angularFrequencies)).asDiagonal();
    Eigen::MatrixXd stiffness = model.angularFrequencies.cwiseAbs2().asDiagonal();

    for (const auto& finger : fingers)
    {
        const auto at = shapesAt (model, finger.x, finger.y);
        mass += finger.mass * at.transpose() * at;
        damping += finger.damping * at.transpose() * at;
        stiffness += finger.stiffness * at.transpose() * at;
    }

    const Eigen::MatrixXd inverse = (mass + h / 2 * damping + h * h / 4 * stiffness).inverse();
    Eigen::VectorXd q = Eigen::VectorXd::Zero (model.modes()), v = q, a = q;
    Eigen::MatrixXd motion (voltages.values.cols(), shapes (0).rows());

    for (Eigen::Index n = 0; n < motion.rows(); ++n)
    {
        motion.row (n) =
            (shapes (voltages.firstTime + static_cast<double> (n) / voltages.playback.sampleRate) * q).transpose();
        const Eigen::VectorXd now = voltages.values.col (n);
        const Eigen::VectorXd next = n + 1 < motion.rows() ? Eigen::VectorXd (voltages.values.col (n + 1)) : now;

        for (int i = 1; i <= steps; ++i)
        {
            const Eigen::VectorXd force = model.participation * (now + (next - now) * i / steps);
            const Eigen::VectorXd ahead = q + h * v + h * h / 4 * a, faster = v + h / 2 * a;
            a = inverse * (force - damping * faster - stiffness * ahead);
            q = ahead + h * h / 4 * a;
            v = faster + h / 2 * a;
        }
    }

    return motion;
}
} // namespace

TEST_CASE ("A finger gets its track and the other one silence, on a surface that both load", "[tracks]")
{
    const auto model = test::SinePlate().model (10);
    auto description = twoPoints (1e-6);
    description.tracks[0].point.finger = builtInFinger ("medium", 0.05, 0.06);
    description.silent[0].finger = builtInFinger ("medium", 0.14, 0.1);
    std::vector<Finger> fingers { *description.tracks[0].point.finger, *description.silent[0].finger };

    for (auto* finger :
         { &fingers[0], &fingers[1], &*description.tracks[0].point.finger, &*description.silent[0].finger })
        finger->radius = 0;

    const auto design = designTracks (model, description, settingsFor (48000));
    CHECK (design.error < 1e-3);
    CHECK (design.peaks.maxCoeff() < 150);
    const auto shapes = [&] (double) { return touchedShapes (model, description); };
    const auto motion = steppedMotion (model, shapes, fingers, design.voltages);
    const auto trigger = std::llround (-design.voltages.firstTime * 48000);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (motion.rows(), 2);
    wanted.middleRows (trigger, design.wanted.rows()) = design.wanted;

    // -54 dB: straight lines between samples, where playback is band-limited, take 3e-4 of a tone of 800 Hz.
    CHECK ((motion - wanted).col (0).norm() < 2e-3 * wanted.norm());
    CHECK ((motion - wanted).col (1).norm() < 2e-3 * wanted.norm());

    // A design that does not know of the fingers is far off.
    description.tracks[0].point.finger.reset();
    description.silent[0].finger.reset();
    const auto bare = designTracks (model, description, settingsFor (48000));
    const auto loaded = steppedMotion (model, shapes, fingers, bare.voltages);
    CHECK ((loaded - wanted).norm() > 0.1 * wanted.norm());
}

TEST_CASE ("A finger that moves gets its track on its way, and the others silence", "[tracks]")
{
    const auto model = test::SinePlate().model (10);
    auto description = twoPoints (1e-6);
    description.tracks[0].events[0].signal = ToneSignal { 350, 0.1, 0.02, 0, 1 };
    description.tracks[0].point.path = { { 0.01, 0.05, 0.06 }, { 0.06, 0.09, 0.04 }, { 0.09, 0.11, 0.06 } };
    const auto design = designTracks (model, description, settingsFor (48000));
    CHECK (design.error < 1e-3);

    // Straight lines from corner to corner, by shapes of the sine plate in closed form.
    const test::SinePlate plate;
    const auto halves = plate.halfWaves (10);
    const auto shapes = [&] (double time)
    {
        const auto leg = time < 0.06 ? std::clamp ((time - 0.01) / 0.05, 0.0, 1.0) : 1.0;
        const auto next = std::clamp ((time - 0.06) / 0.03, 0.0, 1.0);
        const Eigen::Vector2d moving (0.05 + 0.04 * leg + 0.02 * next, 0.06 - 0.02 * leg + 0.02 * next);
        const Eigen::Vector2d resting (0.14, 0.1);
        Eigen::MatrixXd rows (2, 10);

        for (Eigen::Index k = 0; k < 10; ++k)
        {
            const auto [m, n] = halves[static_cast<std::size_t> (k)];
            const auto at = [&, mx = m * std::numbers::pi / plate.lengthX,
                             ny = n * std::numbers::pi / plate.lengthY] (const Eigen::Vector2d& place)
            { return plate.amplitude() * std::sin (mx * place.x()) * std::sin (ny * place.y()); };
            rows (0, k) = at (moving);
            rows (1, k) = at (resting);
        }

        return rows;
    };
    const auto motion = steppedMotion (model, shapes, {}, design.voltages);
    const auto trigger = std::llround (-design.voltages.firstTime * 48000);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (motion.rows(), 2);
    wanted.middleRows (trigger, design.wanted.rows()) = design.wanted;

    // As where it stays: -54 dB.
    CHECK ((motion - wanted).col (0).norm() < 2e-3 * wanted.norm());
    CHECK ((motion - wanted).col (1).norm() < 2e-3 * wanted.norm());

    // A design for the place where it begins is far off.
    description.tracks[0].point.path.clear();
    const auto resting = designTracks (model, description, settingsFor (48000));
    CHECK ((steppedMotion (model, shapes, {}, resting.voltages) - wanted).norm() > 0.1 * wanted.norm());
}

TEST_CASE ("Paths that no finger takes are refused in one sentence", "[tracks]")
{
    const auto model = test::SinePlate().model (10);
    const auto refusal = [&] (const std::vector<PathPoint>& path, bool hasFinger = false)
    {
        auto description = twoPoints (1e-6);
        description.tracks[0].point.path = path;

        if (hasFinger)
            description.tracks[0].point.finger = builtInFinger ("medium", 0.05, 0.06);

        return errorText ([&] { designTracks (model, description, settingsFor (48000)); });
    };
    CHECK (refusal ({ { 0, 0.05, 0.06 }, { 0.1, 0.05, 0.16 } })
           == "waveforms: track 1 path 2 y: is 160 mm, which is outside the surface; allowed: 0 to 150 mm");
    CHECK_THAT (refusal ({ { 0, 0.05, 0.06 }, { 0, 0.06, 0.06 } }),
                Catch::Contains ("track 1 path 2 time: is 0 ms, not after the one before"));
    CHECK_THAT (refusal ({ { 0, 0.05, 0.06 }, { 0.01, 0.15, 0.06 } }),
                Catch::Contains ("path 2: is reached at 10000 mm/s; allowed: 2000 mm/s or less"));
    CHECK_THAT (refusal ({ { 0, 0.05, 0.06 }, { 0.1, 0.06, 0.06 } }, true), Catch::Contains ("track 1 finger: moves"));

    // On its way it comes too near to the silent finger at 140, 100 mm.
    CHECK_THAT (refusal ({ { 0, 0.05, 0.1 }, { 0.1, 0.15, 0.1 } }),
                Catch::Contains ("mm from track 1 at ") && Catch::Contains (" ms, too near"));
}

TEST_CASE ("A path that crosses a silent finger once is noticed however long it is", "[tracks]")
{
    auto description = twoPoints (1e-6);
    auto& path = description.tracks[0].point.path;

    for (int leg = 0; leg <= 10; ++leg)
        path.push_back ({ 0.06 * leg, leg % 2 == 0 ? 0.05 : 0.15, 0.02 });

    // It meets the silent finger at 1.17 m of its way.
    path.push_back ({ 0.66, 0.14, 0.02 });
    path.push_back ({ 0.74, 0.14, 0.12 });
    const auto model = test::SinePlate().model (10);
    CHECK_THAT (errorText ([&] { requireDistinctPoints (model, description); }), Catch::Contains ("too near"));
}

TEST_CASE ("Paths that would take too much memory are refused before their shapes are computed", "[tracks]")
{
    const auto model = test::SinePlate().model (10);
    auto description = twoPoints (1e-6);
    description.silent.clear();
    description.tracks[0].point.path = { { 0, 0, 0 }, { 10, 10, 0 } };

    // Shapes every half millimetre: 20001 places of 10 m, 10 modes, 8 bytes.
    description.tracks.resize (static_cast<std::size_t> (double (1 << 30) / (20001 * 10 * 8)), description.tracks[0]);
    CHECK (errorText ([&] { requirePathMemory (model, description); }).empty());
    description.tracks.resize (1000, description.tracks[0]);
    CHECK (errorText ([&] { requirePathMemory (model, description); })
           == "waveforms: have paths that need 1.49 GiB; allowed: 1 GiB, about 67 % of their length with this device");
}

TEST_CASE ("Voltages and slew rates keep their limits where these bind", "[tracks]")
{
    auto model = test::SinePlate().model (10);
    const auto free = designTracks (model, twoPoints (1e-6), settingsFor (48000));
    REQUIRE (free.limitUse.unlimitedPeak < 1);
    const auto peak = free.peaks.maxCoeff();

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = 0.8 * peak;

    const auto limited = designTracks (model, twoPoints (1e-6), settingsFor (48000));
    CHECK (limited.limitUse.unlimitedPeak == Approx (1.25).epsilon (1e-6));
    CHECK (limited.voltages.values.cwiseAbs().maxCoeff() <= 0.8 * peak);
    CHECK (limited.error <= acceptedTrackError);
    CHECK (limited.limitUse.peakBound <= 1 + 1e-9);

    const auto steepest = [] (const Eigen::MatrixXd& v)
    { return 48000 * (v.rightCols (v.cols() - 1) - v.leftCols (v.cols() - 1)).cwiseAbs().maxCoeff(); };

    for (auto& ceramic : model.ceramics)
    {
        ceramic.voltageLimit = 150;
        ceramic.slewLimit = 0.9 * steepest (free.voltages.values);
    }

    // Slew rates are kept by lower voltages, so the level falls with them.
    double share = 1;

    try
    {
        designTracks (model, twoPoints (1e-6), settingsFor (48000));
    }
    catch (const TrackLimitError& error)
    {
        share = error.share;
    }

    CHECK (share > 0.85);
    const auto slower = designTracks (model, twoPoints (0.99e-6 * share), settingsFor (48000));
    CHECK (steepest (slower.voltages.values) <= model.ceramics[0].slewLimit * (1 + 1e-12));
}

TEST_CASE ("Waveforms that cannot be are refused in one sentence", "[tracks]")
{
    const auto model = test::SinePlate().model (10);
    const auto refusal = [&] (const WaveformsDescription& description, double rate)
    { return errorText ([&] { designTracks (model, description, settingsFor (rate)); }); };
    auto description = twoPoints (1e-6);
    description.silent[0].x = 0.3;
    CHECK (refusal (description, 48000)
           == "waveforms: silent finger 1 x: is 300 mm, which is outside the surface; allowed: 0 to 200 mm");

    description = twoPoints (1e-6);
    description.silent[0].x = 0.0505;
    description.silent[0].y = 0.06;
    const auto near = refusal (description, 48000);
    CHECK_THAT (near, Catch::Contains ("silent finger 1: is 0.5 mm from track 1") && Catch::Contains ("mm or more"));

    // And the distance that it names is enough.
    const auto least = std::stod (near.substr (near.find ("allowed: ") + 9)) / 1000;
    description.silent[0].x = 0.05 + least;
    CHECK (refusal (description, 48000).find ("too near") == std::string::npos);

    description = twoPoints (1e-6);
    description.tracks[0].events[0].signal = ToneSignal { 300, 3000, 0.01, 0, 1 };
    CHECK_THAT (refusal (description, 48000), Catch::Contains ("last 3000 s") && Catch::Contains ("allowed: 1 GiB"));
    CHECK_THAT (refusal (twoPoints (1e-6), 4000),
                Catch::Contains ("sample rate") && Catch::Contains ("4800 Hz or more"));

    description = twoPoints (1e-6);
    description.silent.resize (12);
    CHECK_THAT (refusal (description, 48000), Catch::Contains ("touch 13 points; allowed: at most 12"));
}

TEST_CASE ("A level beyond all voltages is refused with the share of it that can be reached", "[tracks]")
{
    auto model = test::SinePlate().model (10);
    model.dampingRatios *= 4; // short ringing, quick transforms

    try
    {
        designTracks (model, twoPoints (1e-3), settingsFor (4800));
        FAIL ("1 mm was reached");
    }
    catch (const TrackLimitError& error)
    {
        CHECK_THAT (error.what(), Catch::Contains ("times the limits of the device; reachable: "));
        CHECK (error.bound <= 1);
        CHECK_NOTHROW (designTracks (model, twoPoints (0.99e-3 * error.share), settingsFor (4800)));
    }
}
