#include "PlayerFixtures.h"

#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** What the synthesiser of a place gives by itself, from a sample on. */
Eigen::MatrixXd alone (const FocusBank& bank, int place, std::int64_t start, double amplitude, Eigen::Index length)
{
    const auto& focus = *bank.foci[static_cast<std::size_t> (place)];
    Eigen::MatrixXd voltages (playerCeramics, length);
    focus.synthesiser.process (-start, voltages);
    return amplitude * voltages;
}
} // namespace

TEST_CASE ("A trigger plays its place from its sample on, times its amplitude", "[engine][player]")
{
    const auto bank = variedBank (10);
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (std::make_unique<const FocusBank> (*bank));
    const auto result = played (player, { triggerAt (37, 60, 0.7) }, 1000, { 64 });
    const auto expected = alone (*bank, 60, 37, 0.7, 1000);
    CHECK ((result - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
    CHECK (result.leftCols (36).cwiseAbs().maxCoeff() == 0);
    CHECK (player.counters().triggered == 1);
    CHECK (player.activeVoices() == 0);
}

TEST_CASE ("Sixteen foci at once add up", "[engine][player]")
{
    const auto bank = variedBank (10);
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (std::make_unique<const FocusBank> (*bank));
    std::vector<TimedEvent> events;
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero (playerCeramics, 1200);

    for (int i = 0; i < 16; ++i)
    {
        events.push_back (triggerAt (5 * i, 127 - 7 * i, 0.1 + 0.05 * i));
        expected += alone (*bank, 127 - 7 * i, 5 * i, 0.1 + 0.05 * i, 1200);
    }

    const auto result = played (player, events, 1200, { 100 });
    CHECK ((result - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
    CHECK (player.counters().stolen == 0);
}

TEST_CASE ("Blocks of any size give the same samples to the bit, whatever happens in them", "[engine][player]")
{
    for (const auto noteOff : { NoteOffBehaviour::ignore, NoteOffBehaviour::fade })
        for (const auto onNote : { false, true })
        {
            PlayerSettings settings;
            settings.noteOff = noteOff;
            settings.retrigger = onNote ? RetriggerBehaviour::restart : RetriggerBehaviour::overlap;
            settings.focusOnNote = onNote;
            const auto events = randomEvents (5000, 20000, 3);
            const auto render = [&] (const std::vector<int>& blocks)
            {
                FocusPlayer player (playerCeramics, playerRate, settings);
                player.handOver().give (variedBank (10));
                const auto result = played (player, events, 20000, blocks);
                CHECK (player.counters().stolen > 0);
                return result;
            };
            const auto whole = render ({ 20000 });
            CHECK (render ({ 1 }) == whole);
            CHECK (render ({ 64 }) == whole);
            CHECK (render ({ 7, 512, 1, 33 }) == whole);
            CHECK (whole.allFinite());
        }
}

TEST_CASE ("The twenty-fifth voice fades the oldest out, smoothly", "[engine][player]")
{
    // One place of constant voltage for a second: what is heard is how many voices there are.
    auto bank = std::make_unique<FocusBank>();
    auto program = shortProgram (0, 1, 1);
    program.oscillations[0].growth = 0;
    program.oscillations[0].inPhase = 0;
    program.oscillations[0].quadrature = 1;
    bank->foci[0] =
        std::make_shared<const PlayableFocus> (program, Playback { Reconstruction::bandLimited, playerRate });
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (std::move (bank));
    std::vector<TimedEvent> events;

    for (int i = 0; i < 25; ++i)
        events.push_back (triggerAt (100 * i, 0));

    const auto result = played (player, events, 4000, { 50 });
    CHECK (result (0, 2390) == Approx (24));
    CHECK (result (0, 3990) == Approx (24));
    CHECK (player.counters().stolen == 1);
    CHECK (player.counters().cut == 0);

    // The new voice steps in by one volt (half on its first sample); the old one takes 96 samples to leave.
    const Eigen::RowVectorXd steps = (result.row (0).tail (1500) - result.row (0).segment (2499, 1500));
    CHECK (steps.cwiseAbs().maxCoeff() < 0.03);
}

TEST_CASE ("Retrigger, note-off and stop", "[engine][player]")
{
    PlayerSettings settings;
    settings.noteOff = NoteOffBehaviour::fade;
    settings.retrigger = RetriggerBehaviour::restart;
    const auto bank = variedBank (10);
    FocusPlayer player (playerCeramics, playerRate, settings);
    player.handOver().give (std::make_unique<const FocusBank> (*bank));
    const auto fade = static_cast<std::int64_t> (settings.fadeTime * playerRate);

    SECTION ("a released focus is silent after the fade")
    {
        const auto result = played (player, { triggerAt (0, 100), releaseAt (200, 100) }, 800, { 64 });
        CHECK (result.rightCols (800 - 200 - fade).cwiseAbs().maxCoeff() == 0);
        CHECK (result.leftCols (200) == alone (*bank, 100, 0, 1, 800).leftCols (200));
    }

    SECTION ("a place that is triggered again begins anew and leaves its first voice")
    {
        const auto result = played (player, { triggerAt (0, 100), triggerAt (300, 100) }, 2000, { 64 });
        const auto expected = alone (*bank, 100, 300, 1, 2000);
        const auto after = 300 + fade;
        CHECK ((result - expected).rightCols (2000 - after).cwiseAbs().maxCoeff()
               < 1e-12 * expected.cwiseAbs().maxCoeff());
    }

    SECTION ("stop fades all")
    {
        const auto result =
            played (player, { triggerAt (0, 100), triggerAt (3, 90), { 200, { 0, FocusEventKind::stopAll, 0, 0 } } },
                    800, { 64 });
        CHECK (result.rightCols (800 - 200 - fade).cwiseAbs().maxCoeff() == 0);
        CHECK (player.activeVoices() == 0);
    }
}

TEST_CASE ("On the note falls the focus, whatever its length", "[engine][player]")
{
    PlayerSettings settings;
    settings.focusOnNote = true;
    const auto bank = variedBank (10);
    FocusPlayer player (playerCeramics, playerRate, settings);
    player.handOver().give (std::make_unique<const FocusBank> (*bank));
    const auto latest = bank->latestFocusSample();
    const auto result = played (player, { triggerAt (10, 3) }, 1500, { 64 });
    CHECK (player.latencySamples() == latest);
    const auto focusSample = bank->foci[3]->synthesiser.focusSample();
    const auto expected = alone (*bank, 3, 10 + latest - focusSample, 1, 1500);
    CHECK ((result - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE ("A sounding voice finishes on the design it began with", "[engine][player]")
{
    const auto first = variedBank (10), second = variedBank (3);
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (std::make_unique<const FocusBank> (*first));
    const auto before = played (player, { triggerAt (0, 120) }, 100, { 50 });
    player.handOver().give (std::make_unique<const FocusBank> (*second));
    const auto after = played (player, { triggerAt (0, 20) }, 900, { 50 });
    const auto expected = alone (*first, 120, 0, 1, 1000);
    const Eigen::MatrixXd sum = expected.rightCols (900) + alone (*second, 20, 0, 1, 900);
    CHECK ((before - expected.leftCols (100)).cwiseAbs().maxCoeff() < 1e-12);
    CHECK ((after - sum).cwiseAbs().maxCoeff() < 1e-11);
}

TEST_CASE ("Banks come back and are freed by the worker", "[engine][player]")
{
    FocusPlayer player (playerCeramics, playerRate, {});
    std::weak_ptr<const PlayableFocus> watched;
    {
        auto bank = std::make_unique<FocusBank>();
        const auto focus = std::make_shared<const PlayableFocus> (shortProgram (500, 0.002, 1),
                                                                  Playback { Reconstruction::bandLimited, playerRate });
        bank->foci[0] = focus;
        watched = focus;
        player.handOver().give (std::move (bank));
    }
    played (player, { triggerAt (0, 0) }, 10, { 10 });
    player.handOver().give (variedBank (1, 4));
    played (player, {}, 10, { 10 });
    player.handOver().collect();
    CHECK_FALSE (watched.expired()); // It still sounds.
    played (player, {}, 500, { 50 });
    player.handOver().collect();
    CHECK (watched.expired());
}

TEST_CASE ("Events that make no sense do nothing", "[engine][player]")
{
    FocusPlayer player (playerCeramics, playerRate, {});
    CHECK (played (player, { triggerAt (0, 5) }, 10, { 10 }).cwiseAbs().maxCoeff() == 0); // no bank yet
    player.handOver().give (variedBank (10, 4));
    const auto result = played (player,
                                { triggerAt (0, -1), triggerAt (1, 128), triggerAt (2, 77),
                                  triggerAt (3, 0, std::nan ("")), releaseAt (4, -7) },
                                100, { 64 });
    CHECK (result.cwiseAbs().maxCoeff() == 0);
    CHECK (player.counters().empty == 5);
    CHECK_THROWS_AS (FocusPlayer (0, playerRate, {}), InputError);
    CHECK_THROWS_AS (FocusPlayer (1, -1, {}), InputError);
}

TEST_CASE ("Playing allocates nothing, with all voices and changing banks", "[engine][player]")
{
    // 0 where allocations are not counted.
    CHECK (allocationsWhilePlaying ([] (int filled) { return variedBank (10, filled); }) == 0);
}
