#include "LearningBench.h"

#include <antinode_base/InputError.h>
#include <antinode_learning/LearningParameters.h>
#include <antinode_learning/LearntDesign.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_learning/PlayedVoltages.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr Eigen::Index count = 4800;

/** A row of U sin (2 pi f t), under a window that is smooth at both ends. */
Eigen::RowVectorXd burst (double voltage, double frequency)
{
    return Eigen::RowVectorXd::NullaryExpr (
        count,
        [=] (Eigen::Index n)
        {
            const auto t = static_cast<double> (n) / rate, whole = static_cast<double> (count) / rate;
            const auto window = std::pow (std::sin (std::numbers::pi * t / whole), 2);
            return voltage * window * std::sin (2 * std::numbers::pi * frequency * t);
        });
}
} // namespace

TEST_CASE ("The cube of a sine is three quarters of it and a quarter of its third harmonic", "[learning]")
{
    // sin^3 x = (3 sin x - sin 3 x) / 4; of 9 kHz the third harmonic lies beyond half the rate and is left out.
    const auto middle = count / 2, some = count / 20;

    for (const auto frequency : { 1000.0, 9000.0 })
    {
        const auto harmonic = 3 * frequency < rate / 2 ? 0.25 : 0.0;
        const auto cube = cubedVoltages (burst (2, frequency));
        const Eigen::RowVectorXd wanted = 8 * (0.75 * burst (1, frequency) - harmonic * burst (1, 3 * frequency));
        CAPTURE (frequency);
        // In the middle the window is 1 to within 1 %, its cube to within 3 %.
        CHECK ((cube - wanted).middleCols (middle - some, 2 * some).norm()
               < 0.05 * wanted.middleCols (middle - some, 2 * some).norm());
    }
}

TEST_CASE ("Voltages of ceramics that distort are added to their cubes, where these are known", "[learning]")
{
    const Eigen::MatrixXd voltages = (Eigen::MatrixXd (2, count) << burst (3, 700), burst (1, 900)).finished();
    const Eigen::Vector2d distortions (0.01, -0.02);
    const PlayedVoltages linear (voltages, rate), cubic (voltages, cubedVoltages (voltages), rate);
    CHECK_FALSE (linear.hasCubes());
    CHECK (linear.distorted (distortions).of (0) == linear.of (0));

    const auto acting = cubic.distorted (distortions);

    for (Eigen::Index i = 0; i < 2; ++i)
    {
        const Eigen::VectorXd expected =
            cubic.of (i).array() + distortions[i] * Eigen::VectorXd (cubic.of (i)).array().cube();
        CHECK ((acting.of (i) - expected).norm() < 1e-3 * std::abs (distortions[i]) * expected.norm());
    }
}

TEST_CASE ("Cubes are filtered and thinned as the voltages are", "[learning]")
{
    const WideModel model { sineBeam (allModes, 1), knownModes, {} };
    PlayedRecording recording { 192000, Eigen::MatrixXd (1, 40000), Eigen::MatrixXd (1, 40000),
                                Eigen::VectorXd::Constant (1, 0.1) };
    RandomNumbers random (7);
    recording.voltages.row (0) = random.normal (40000);
    recording.signals = recording.voltages;
    recording.cubes = recording.voltages;
    const auto heard = withinModel (recording, model);
    REQUIRE (heard.sampleRate < recording.sampleRate);
    CHECK (heard.cubes == heard.signals);
}

TEST_CASE ("Cubes are known of all voltages, or of none", "[learning]")
{
    const Bench bench (0.005, 1);
    const auto deviations = sameSpread (allModes, 0.005, 0.1, 0.05);
    auto one = bench (bench.exactVoltages(), 0), other = one;
    const auto isUsable = [&]
    {
        try
        {
            requireUsable (bench.nominal.model, bench.sensors(), deviations, { one, other });
            return true;
        }
        catch (const InputError&)
        {
            return false;
        }
    };
    CHECK (isUsable());
    other.cubes = cubedVoltages (other.voltages);
    CHECK_FALSE (isUsable());
    one.cubes = other.cubes;
    CHECK (isUsable());
    one.cubes = other.cubes.leftCols (10);
    CHECK_FALSE (isUsable());
    one.cubes = other.cubes;
    one.cubes (0, 5) = std::nan ("");
    CHECK_FALSE (isUsable());
}

TEST_CASE ("A ceramic that hardly plays has a deviation that a hundredth of the others' voltage gives", "[learning]")
{
    const auto model = sineBeam (allModes, 3);
    const std::vector<Sensor> sensors { { shapesAt (model, 0.03, 0) } };
    const auto deviations = sameSpread (allModes, 0.005, 0.1, 0.05);
    PlayedRecording recording { rate, Eigen::MatrixXd::Zero (3, count), Eigen::MatrixXd::Zero (1, count),
                                Eigen::VectorXd::Constant (1, 0.1) };
    recording.voltages.row (0) = burst (40, 500);
    recording.voltages.row (1) = burst (1e-6, 500);
    recording.cubes = cubedVoltages (recording.voltages);
    auto later = recording;
    later.voltages.row (2) = burst (20, 500);
    later.cubes = cubedVoltages (later.voltages);
    const std::vector<PlayedRecording> first { recording }, both { recording, later };
    const auto alone = makePrior (model, sensors, deviations, first).distortionDeviations;
    CHECK (alone[0] == Approx (0.02 / 1600).epsilon (1e-3));
    CHECK (alone[1] == Approx (0.02 / 0.16).epsilon (1e-3));
    CHECK (alone[2] == 0);
    CHECK (makePrior (model, sensors, deviations, both).distortionDeviations[2] == Approx (0.02 / 400).epsilon (1e-3));
}

TEST_CASE ("Under a long tone a ceramic that distorts acts by the gain of a describing function", "[learning]")
{
    // Of c U^3 the fundamental has 3/4 (Gelb and Vander Velde, Multiple-Input Describing Functions, 1968).
    const auto model = sineBeam (5, 3);
    constexpr Eigen::Index mode = 2, ceramic = 1;
    constexpr double voltage = 40, distortion = 2e-5; // V, 1/V^2
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (3, 9600);

    for (Eigen::Index n = 0; n < 9000; ++n)
        voltages (ceramic, n) =
            voltage * std::sin (model.angularFrequencies[mode] * static_cast<double> (n) / benchRate);

    LearntModes learnt;
    learnt.model = model;
    learnt.distortions = distortion * Eigen::VectorXd::Unit (3, ceramic);
    const auto equivalent = equivalentLinear (learnt, voltages, benchRate, 0.3);
    const auto gain = equivalent.participation (mode, ceramic) / model.participation (mode, ceramic);
    CHECK (gain - 1 == Approx (0.75 * distortion * voltage * voltage).epsilon (0.02));
    CHECK (equivalent.participation.col (0) == model.participation.col (0));
    CHECK (distortionShares (learnt.distortions, voltages)[ceramic] == Approx (0.032).epsilon (1e-3));

    learnt.distortions.setZero();
    CHECK (equivalentLinear (learnt, voltages, benchRate, 0.3).participation == model.participation);
}

TEST_CASE ("At the focus the equivalent linear device moves like the one whose ceramics distort", "[learning]")
{
    Bench bench (0.005, 3);
    const auto voltages = bench.exactVoltages();
    const Eigen::VectorXd largest = voltages.rowwise().lpNorm<Eigen::Infinity>();
    bench.distortions = 0.03 * largest.cwiseAbs2().cwiseInverse();
    LearntModes learnt;
    learnt.model = bench.truth;
    learnt.distortions = bench.distortions;
    const auto time = sincFocus().focusTime;
    const auto at = static_cast<Eigen::Index> (time * benchRate);
    const auto equivalent = equivalentLinear (learnt, voltages, benchRate, time);
    const auto distorted = bench.field (voltages);
    const Eigen::VectorXd linear = played (bench.truth, bench.truth.shapes, voltages).col (at);
    const Eigen::VectorXd likeIt = played (equivalent, bench.truth.shapes, voltages).col (at);
    const auto& surface = bench.truth.surface;
    CHECK (scoreField (surface, linear, distorted).fieldError > 0.01);
    CHECK (scoreField (surface, likeIt, distorted).fieldError < 0.001);
}

TEST_CASE ("How much each ceramic distorts is learnt, and the focus is exact in spite of it", "[learning]")
{
    for (const std::uint64_t seed : { 1, 2 })
    {
        Bench bench (0.005, seed);
        const Eigen::VectorXd largest = bench.exactVoltages().rowwise().lpNorm<Eigen::Infinity>();
        const Eigen::VectorXd shares = (Eigen::VectorXd (5) << 0.03, 0, -0.02, 0.05, 0.01).finished();
        bench.distortions = shares.cwiseQuotient (largest.cwiseAbs2());
        Eigen::MatrixXd last;
        const auto play = [&] (const Eigen::MatrixXd& volts, int pass)
        {
            last = volts;
            return bench (volts, pass);
        };
        const auto learnt = learn (bench, play);
        CAPTURE (seed, learnt.refusal);
        REQUIRE (learnt.refusal.empty());
        CHECK (learnt.learnt.residual == Approx (1).margin (0.02));
        CHECK (bench.fieldError (last) < 0.005);

        for (Eigen::Index i = 0; i < 5; ++i)
        {
            const auto error = std::abs (learnt.learnt.distortions[i] - bench.distortions[i]);
            CAPTURE (i, largest[i], error / learnt.learnt.distortionDeviations[i]);
            CHECK (error < 4 * learnt.learnt.distortionDeviations[i]);
            CHECK (learnt.learnt.distortionDeviations[i] * largest[i] * largest[i] < 0.02);
        }
    }
}
