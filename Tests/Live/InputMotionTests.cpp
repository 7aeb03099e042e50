#include <antinode_numerics/Statistics.h>
#include <antinode_tracks/FilterPlayer.h>
#include <antinode_tracks/FingerFilters.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double inputRate = 4000;
constexpr Eigen::Index past = 400;

const SkinThreshold stepThreshold { "steps", Eigen::Vector3d (40, 250, 1000), Eigen::Vector3d (1e-5, 1e-7, 1e-5) };

/** What is asked for by a tone of 1 um, once it is steady. */
std::pair<double, double> steadyMotion (double frequency)
{
    InputMotion motion (inputRate, { 40, 1000 }, stepThreshold, past, 1);
    const Eigen::RowVectorXf tone = Eigen::RowVectorXf::NullaryExpr (
        3000,
        [&] (auto n)
        {
            return static_cast<float> (
                1e-6 * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (n) / inputRate));
        });

    for (Eigen::Index n = past; n < tone.size(); ++n)
    {
        if (n == 2000)
        {
            motion.takeDisplacement (0);
            motion.takeFelt (0);
        }

        motion.take (0, tone.segment (n - past, past));
    }

    return { static_cast<double> (motion.takeDisplacement (0)), static_cast<double> (motion.takeFelt (0)) };
}
} // namespace

TEST_CASE ("A tone asks for its displacement and is felt by it over the threshold", "[live]")
{
    for (const auto frequency : { 80.0, 250.0, 600.0 })
    {
        const auto [displacement, felt] = steadyMotion (frequency);
        // The window of 0.1 s smears the threshold's corner over 20 Hz.
        CHECK (displacement == Approx (1e-6).epsilon (0.01));
        CHECK (felt == Approx (1e-6 / thresholdAt (stepThreshold, frequency)).epsilon (frequency == 250 ? 0.1 : 0.03));
    }
}

TEST_CASE ("What lies outside of the band is neither asked for nor felt", "[live]")
{
    for (const auto frequency : { 0.0, 5.0, 1200.0, 1900.0 })
    {
        const auto [displacement, felt] = steadyMotion (frequency);
        CHECK (displacement < 2e-9);
        CHECK (felt < 0.05);
    }
}

TEST_CASE ("The noise gain of filters is that of noise in the band, by its spectrum", "[live]")
{
    RandomNumbers random (3);
    FingerFilters filters { 48000, 12, 20, {}, 0, 0 };
    filters.taps.push_back (Eigen::MatrixXd::NullaryExpr (60, 2, [&] { return random.uniform() - 0.5; }));
    const TrackBand band { 100, 900 };
    const auto gains = noiseGains (filters, band);
    REQUIRE (gains.rows() == 2);
    REQUIRE (gains.cols() == 1);

    for (Eigen::Index i = 0; i < 2; ++i)
    {
        double power = 0;
        int tones = 0;

        for (double frequency = 100; frequency <= 900; frequency += 1)
        {
            std::complex<double> response;

            for (Eigen::Index k = 0; k < 60; ++k)
                response += filters.taps[0](k, i)
                            * std::polar (1.0, -2 * std::numbers::pi * frequency * static_cast<double> (k) / inputRate);

            power += std::norm (response);
            ++tones;
        }

        CHECK (gains (i, 0) == Approx (std::sqrt (power / tones)).epsilon (0.03));
    }
}

TEST_CASE ("A bank with more inputs than tracks plays each track from its own input", "[live]")
{
    RandomNumbers random (4);
    FingerFilters filters { 48000, 12, 20, {}, 0, 0 };

    for (int j = 0; j < 2; ++j)
        filters.taps.push_back (Eigen::MatrixXd::NullaryExpr (60, 3, [&] { return random.uniform() - 0.5; }));

    const auto dense = filterBank (filters), wide = filterBank (filters, { 3, 1 }, 5);
    FilterPlayer one (dense, 1), other (wide, 1);
    Eigen::VectorXf expected (3), played (3), few (2), many (5);

    for (int n = 0; n < 3000; ++n)
    {
        many = Eigen::VectorXf::NullaryExpr (5, [&] { return static_cast<float> (random.uniform()); });
        few << many[3], many[1];
        one.process (few, expected);
        other.process (many, played);
        REQUIRE ((played - expected).norm() < 1e-4F); // Sums in another order.
    }
}

TEST_CASE ("A player that is reset forgets what it has played", "[live]")
{
    RandomNumbers random (5);
    FingerFilters filters { 48000, 12, 20, {}, 0, 0 };
    filters.taps.push_back (Eigen::MatrixXd::NullaryExpr (60, 3, [&] { return random.uniform() - 0.5; }));
    const auto bank = filterBank (filters);
    FilterPlayer player (bank, 1), fresh (bank, 1);
    Eigen::VectorXf voltages (3), expected (3);

    for (int n = 0; n < 1003; ++n)
        player.process (Eigen::VectorXf::Ones (1), voltages);

    player.reset();

    for (int n = 0; n < 1000; ++n)
    {
        player.process (Eigen::VectorXf::Constant (1, n == 20 ? 1 : 0), voltages);
        fresh.process (Eigen::VectorXf::Constant (1, n == 20 ? 1 : 0), expected);
        REQUIRE (voltages == expected);
    }
}

TEST_CASE ("The timing of filters is known before they are designed", "[live]")
{
    FilterSettings settings;
    settings.latency = 0.005;
    CHECK (filterTiming ({ 40, 1000 }, settings).latencySamples() == 240);
    settings.sampleRate = 44100;
    const auto timing = filterTiming ({ 40, 1000 }, settings);
    CHECK (timing.factor == 11);
    CHECK (timing.latencySamples() == 20 * 11);
}
