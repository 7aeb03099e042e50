#include "Support/AllocationCount.h"

#include <antinode_numerics/Statistics.h>
#include <antinode_tracks/FilterPlayer.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace antinode;

namespace
{
constexpr Eigen::Index factor = 12, taps = 60, ceramics = 5, inputs = 3;
constexpr double rate = 48000;

FingerFilters randomFilters (std::uint64_t seed)
{
    RandomNumbers random (seed);
    FingerFilters filters { rate, factor, 20, {}, 0, 0 };

    for (Eigen::Index j = 0; j < inputs; ++j)
        filters.taps.push_back (Eigen::MatrixXd::NullaryExpr (taps, ceramics, [&] { return random.uniform() - 0.5; }));

    return filters;
}

/** Tones below a quarter of the filters' rate. */
Eigen::VectorXf tones (Eigen::Index n)
{
    Eigen::VectorXf values (inputs);

    for (Eigen::Index j = 0; j < inputs; ++j)
        values[j] = static_cast<float> (
            std::sin (2 * std::numbers::pi * 210 * static_cast<double> (j + 1) * static_cast<double> (n) / rate));

    return values;
}

/** The same for ever, by the filters' responses at the frequencies of the tones: no rate is changed. */
Eigen::VectorXd steadyVoltages (const FingerFilters& filters, Eigen::Index n)
{
    using namespace std::complex_literals;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero (ceramics);
    const auto time =
        static_cast<double> (n) / rate - filters.latency() + static_cast<double> (filters.delay) / filters.rate();

    for (Eigen::Index j = 0; j < inputs; ++j)
    {
        const auto omega = 2 * std::numbers::pi * 210 * static_cast<double> (j + 1);

        for (Eigen::Index k = 0; k < taps; ++k)
            sum += filters.taps[static_cast<std::size_t> (j)].row (k).transpose()
                   * std::sin (omega * (time - static_cast<double> (k) / filters.rate()));
    }

    return sum;
}

Eigen::MatrixXf played (FilterPlayer& player, Eigen::Index samples)
{
    Eigen::MatrixXf voltages (ceramics, samples);

    for (Eigen::Index n = 0; n < samples; ++n)
        player.process (tones (n), voltages.col (n));

    return voltages;
}
} // namespace

TEST_CASE ("Tones pass as the filters' responses say, in time with the latency", "[live]")
{
    const auto filters = randomFilters (1);
    const auto bank = filterBank (filters);
    FilterPlayer player (bank, 1);
    const auto voltages = played (player, 4000);

    for (Eigen::Index n = 3000; n < 4000; ++n)
        CHECK ((voltages.col (n).cast<double>() - steadyVoltages (filters, n)).norm() < 2e-3);
}

TEST_CASE ("No voltage precedes the input that causes it", "[live]")
{
    const auto bank = filterBank (randomFilters (1));
    FilterPlayer player (bank, 1);
    Eigen::VectorXf voltages (ceramics);
    constexpr Eigen::Index at = 703;
    float before = 0, after = 0;

    for (Eigen::Index n = 0; n < 2 * at; ++n)
    {
        player.process (Eigen::VectorXf::Constant (inputs, n == at ? 1.0f : 0.0f), voltages);
        (n < at ? before : after) += voltages.norm();
    }

    CHECK (before == 0);
    CHECK (after > 0);
}

TEST_CASE ("Another bank takes over within its fade, from the same past, without a step", "[live]")
{
    const auto first = filterBank (randomFilters (1)), second = filterBank (randomFilters (2));
    constexpr Eigen::Index fade = 40, samples = 5000, change = 2500;
    FilterPlayer changing (first, fade), alone (first, fade), other (second, fade);
    const auto before = played (alone, samples), after = played (other, samples);
    Eigen::MatrixXf voltages (ceramics, samples);

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        if (n == change)
            changing.fadeTo (second);

        changing.process (tones (n), voltages.col (n));
    }

    constexpr auto faded = change + (fade + 12) * factor;
    CHECK_FALSE (changing.isFading());
    CHECK (voltages.leftCols (change) == before.leftCols (change));
    CHECK (voltages.rightCols (samples - faded) == after.rightCols (samples - faded));
    const auto steepest = [] (const Eigen::MatrixXf& played)
    { return (played.rightCols (samples - 1000) - played.middleCols (999, samples - 1000)).cwiseAbs().maxCoeff(); };
    CHECK (steepest (voltages) < 1.3f * std::max (steepest (before), steepest (after)));
}

TEST_CASE ("Inputs that are not finite count as silence", "[live]")
{
    const auto bank = filterBank (randomFilters (1));
    FilterPlayer player (bank, 1);
    Eigen::VectorXf voltages (ceramics), input (inputs);

    for (int n = 0; n < 3000; ++n)
    {
        input << std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0;
        player.process (input, voltages);
        REQUIRE (voltages.norm() == 0);
    }
}

TEST_CASE ("Playing filters asks for no memory, also while banks fade", "[live]")
{
    const auto first = filterBank (randomFilters (1)), second = filterBank (randomFilters (2));
    FilterPlayer player (first, 10);
    const Eigen::VectorXf input = Eigen::VectorXf::Ones (inputs);
    Eigen::VectorXf voltages (ceramics);
    const auto before = test::mallocCalls();

    for (int n = 0; n < 2000; ++n)
    {
        if (n == 500)
            player.fadeTo (second);

        player.process (input, voltages);
    }

    CHECK (test::mallocCalls() == before);
}
