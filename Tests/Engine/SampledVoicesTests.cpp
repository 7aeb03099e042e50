#include "PlayerFixtures.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/SampleKernel.h>

#include <catch2/catch.hpp>
#include <hwy/highway.h>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr Playback atPlayerRate { Reconstruction::bandLimited, playerRate };

std::unique_ptr<const FocusBank> bankOf (const VoltageProgram& program, int place = 60)
{
    auto bank = std::make_unique<FocusBank>();
    bank->foci[static_cast<std::size_t> (place)] = std::make_shared<const PlayableFocus> (program, atPlayerRate);
    return bank;
}

/** A program's samples from a sample on, by themselves. */
Eigen::MatrixXd placed (const VoltageProgram& program, Eigen::Index start, double amplitude, Eigen::Index length)
{
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (playerCeramics, length);
    const auto& values = program.samples->values;
    voltages.middleCols (start, values.cols()) = amplitude * values;
    return voltages;
}

Eigen::MatrixXd playedIn (const PlayerSettings& settings, const std::vector<TimedEvent>& events,
                          const std::vector<int>& blocks)
{
    FocusPlayer player (playerCeramics, playerRate, settings);
    player.handOver().give (mixedBank (10));
    const auto result = played (player, events, 20000, blocks);
    CHECK (player.counters().stolen > 0);
    return result;
}
} // namespace

TEST_CASE ("A trigger plays the samples of its place from its sample on, times its amplitude", "[engine][sampled]")
{
    const auto program = sampledProgram (7, 0.0100037, 10); // between two samples
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (bankOf (program));
    const auto expected = placed (program, 37, 0.7, 1000);
    const auto events = std::vector { triggerAt (37, 60, 0.7) };
    CHECK ((played (player, events, 1000, { 64 }) - expected).cwiseAbs().maxCoeff() < 1e-6 * 10);
    CHECK (player.counters().triggered == 1);
    CHECK (player.activeVoices() == 0);
}

TEST_CASE ("Samples and oscillations together: blocks of any size give the same samples to the bit",
           "[engine][sampled]")
{
    const auto noteOff = GENERATE (NoteOffBehaviour::ignore, NoteOffBehaviour::fade);
    const auto onNote = GENERATE (false, true);
    PlayerSettings settings;
    settings.noteOff = noteOff;
    settings.retrigger = onNote ? RetriggerBehaviour::restart : RetriggerBehaviour::overlap;
    settings.focusOnNote = onNote;
    const auto events = randomEvents (5000, 20000, 3);
    const auto whole = playedIn (settings, events, { 20000 });
    CHECK (playedIn (settings, events, { 1 }) == whole);
    CHECK (playedIn (settings, events, { 7, 512, 1, 33 }) == whole);
    CHECK (whole.allFinite());
}

TEST_CASE ("A voice of samples fades, and its focus falls on the note", "[engine][sampled]")
{
    PlayerSettings settings;
    settings.noteOff = NoteOffBehaviour::fade;
    settings.focusOnNote = true;
    const auto program = sampledProgram (9, 0.01, 10);
    auto bank = std::make_unique<FocusBank> (*bankOf (program));
    bank->foci[1] = std::make_shared<const PlayableFocus> (shortProgram (500, 0.015, 1), atPlayerRate);
    FocusPlayer player (playerCeramics, playerRate, settings);
    player.handOver().give (std::move (bank));
    const auto result = played (player, { triggerAt (10, 60), releaseAt (400, 60) }, 1000, { 50 });
    const auto expected = placed (program, 10 + 720 - 480, 1, 1000);
    CHECK (player.latencySamples() == 720); // The later focus of the two.
    CHECK ((result - expected).leftCols (400).cwiseAbs().maxCoeff() < 1e-6 * 10);

    // The fade of 96 samples is half a period of a raised cosine.
    for (int n = 0; n < 96; ++n)
    {
        const auto gain = 0.5 + 0.5 * std::cos (std::numbers::pi * (n + 1) / 96);
        CHECK ((result.col (400 + n) - gain * expected.col (400 + n)).cwiseAbs().maxCoeff() < 1e-6 * 10);
    }

    CHECK (result.rightCols (1000 - 400 - 96).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE ("Kernels add samples the same way at any place of a block, on every instruction set", "[engine][sampled]")
{
    Draws draws (5);
    std::vector<float> from (101);
    std::vector<double> to (101);

    for (std::size_t n = 0; n < from.size(); ++n)
    {
        from[n] = static_cast<float> (draws.next());
        to[n] = draws.next();
    }

    for (const auto target : hwy::SupportedAndGeneratedTargets())
    {
        hwy::SetSupportedTargetsForTest (target);
        const auto add = sampleKernel().addScaled;
        hwy::SetSupportedTargetsForTest (0);
        auto whole = to;
        add (from.data(), 0.3, whole.data(), 101);

        for (std::size_t n = 0; n < from.size(); ++n)
            CHECK (std::abs (whole[n] - (to[n] + 0.3 * static_cast<double> (from[n]))) < 1e-15);

        for (const auto block : { 1, 3, 4, 50 })
        {
            auto cut = to;

            for (int n = 0; n < 101; n += block)
                add (from.data() + n, 0.3, cut.data() + n, std::min (block, 101 - n));

            CHECK (cut == whole);
        }
    }
}

TEST_CASE ("Samples are refused where they were made for another rate, or are not finite", "[engine][sampled]")
{
    auto program = sampledProgram (1, 0.01, 10);
    CHECK_THROWS_WITH (PlayableFocus (program, { Reconstruction::bandLimited, 44100 }),
                       Catch::Contains ("was designed for 48000 Hz, band_limited; design it again for 44100 Hz"));
    program.samples->values (3, 5) = std::nan ("");
    CHECK_THROWS_AS (PlayableFocus (program, atPlayerRate), InputError);
}

TEST_CASE ("The memory of a bank of samples is known and bounded", "[engine][sampled]")
{
    // 8 ceramics, 480 samples to the focus and 32 behind it, 4 bytes each.
    const PlayableFocus small (sampledProgram (1, 0.01, 10), atPlayerRate);
    CHECK (small.sampleBytes() == 8 * 512 * 4);
    CHECK_NOTHROW (requireRoomInBank (small, FocusBank::places));
    const PlayableFocus large (sampledProgram (1, 1.5, 10), atPlayerRate);
    CHECK_NOTHROW (requireRoomInBank (large, 100));
    CHECK_THROWS_WITH (requireRoomInBank (large, 145),
                       Catch::Contains ("needs 319 MiB for the samples of 145 places; allowed: 256 MiB"));
    CHECK (PlayableFocus (shortProgram (500, 0.01, 1), atPlayerRate).sampleBytes() == 0);
}

TEST_CASE ("Playing samples allocates nothing, while banks change", "[engine][sampled]")
{
    // 0 where allocations are not counted.
    CHECK (allocationsWhilePlaying ([] (int filled) { return mixedBank (10, filled); }) == 0);
}
