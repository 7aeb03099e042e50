#pragma once

#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_engine/FocusPlayer.h>

#include <algorithm>
#include <span>
#include <vector>

namespace antinode::test
{
constexpr double playerRate = 48000;
constexpr int playerCeramics = 8;

/** A short focus: one oscillation of a millisecond or so, growing to its focus, then released within a tenth. */
inline VoltageProgram shortProgram (double frequency, double focusTime, double volts)
{
    VoltageProgram program;
    Oscillation oscillation;
    oscillation.end = focusTime;
    oscillation.growth = 2 / focusTime;
    oscillation.angularFrequency = 2 * std::numbers::pi * frequency;
    oscillation.inPhase = std::exp (-2.0);
    program.oscillations = { oscillation };
    program.allocation = Eigen::MatrixXd::Constant (playerCeramics, 1, volts);
    program.allocation (1, 0) *= -0.5;
    program.voltageLimits = Eigen::VectorXd::Constant (playerCeramics, 100);
    program.focusTime = focusTime;
    return program;
}

/** A bank whose places play focuses of different frequencies and lengths. */
inline std::unique_ptr<const FocusBank> variedBank (double volts, int filled = FocusBank::places)
{
    auto bank = std::make_unique<FocusBank>();

    for (int place = 0; place < filled; ++place)
        bank->foci[static_cast<std::size_t> (place)] =
            std::make_shared<const PlayableFocus> (shortProgram (300 + 37 * place, 0.002 + 0.0001 * place, volts),
                                                   Playback { Reconstruction::bandLimited, playerRate });

    return bank;
}

/** The same length as samples: noise of its own on each ceramic. */
inline VoltageProgram sampledProgram (unsigned seed, double focusTime, double volts)
{
    VoltageProgram program;
    Draws draws (seed);
    const auto focus = std::llround (focusTime * playerRate);
    program.allocation.resize (playerCeramics, 0);
    program.voltageLimits = Eigen::VectorXd::Constant (playerCeramics, 100);
    program.focusTime = focusTime;
    program.samples = { { Reconstruction::bandLimited, playerRate },
                        focusTime - static_cast<double> (focus) / playerRate,
                        volts * draws.matrix (playerCeramics, focus + 32) };
    return program;
}

/** A bank of which every other place plays samples. */
inline std::unique_ptr<const FocusBank> mixedBank (double volts, int filled = FocusBank::places)
{
    auto bank = std::make_unique<FocusBank> (*variedBank (volts, filled));

    for (int place = 1; place < filled; place += 2)
        bank->foci[static_cast<std::size_t> (place)] = std::make_shared<const PlayableFocus> (
            sampledProgram (static_cast<unsigned> (place), 0.002 + 0.0001003 * place, volts),
            Playback { Reconstruction::bandLimited, playerRate });

    return bank;
}

struct TimedEvent
{
    std::int64_t sample = 0;
    FocusEvent event;
};

/** Plays events in blocks of the given sizes, over and over, and returns all samples: channels x length. */
inline Eigen::MatrixXd played (FocusPlayer& player, const std::vector<TimedEvent>& timed, Eigen::Index length,
                               const std::vector<int>& blocks)
{
    Eigen::MatrixXd result (playerCeramics, length);
    std::vector<std::vector<double>> buffers (playerCeramics);
    std::size_t next = 0, block = 0;

    for (Eigen::Index start = 0; start < length; ++block)
    {
        const auto count = static_cast<int> (std::min<Eigen::Index> (blocks[block % blocks.size()], length - start));
        std::vector<FocusEvent> events;
        std::vector<double*> channels;

        for (; next < timed.size() && timed[next].sample < start + count; ++next)
        {
            events.push_back (timed[next].event);
            events.back().offset = static_cast<int> (timed[next].sample - start);
        }

        for (auto& buffer : buffers)
        {
            buffer.assign (static_cast<std::size_t> (count), 77.0);
            channels.push_back (buffer.data());
        }

        player.process (channels.data(), count, events);

        for (int i = 0; i < playerCeramics; ++i)
            for (int n = 0; n < count; ++n)
                result (i, start + n) = buffers[static_cast<std::size_t> (i)][static_cast<std::size_t> (n)];

        start += count;
    }

    return result;
}

inline TimedEvent triggerAt (std::int64_t sample, int place, double amplitude = 1)
{
    return { sample, { 0, FocusEventKind::trigger, place, amplitude } };
}

inline TimedEvent releaseAt (std::int64_t sample, int place)
{
    return { sample, { 0, FocusEventKind::release, place, 0 } };
}

/** Triggers and note-offs, at random. */
inline std::vector<TimedEvent> randomEvents (int count, std::int64_t length, unsigned seed)
{
    Draws draws (seed);
    std::vector<TimedEvent> events;

    for (int i = 0; i < count; ++i)
    {
        const auto sample = static_cast<std::int64_t> ((draws.next() + 1) / 2 * static_cast<double> (length - 1));
        const auto place = static_cast<int> ((draws.next() + 1) / 2 * 127);
        events.push_back (draws.next() < 0.5 ? triggerAt (sample, place, (draws.next() + 1) / 2)
                                             : releaseAt (sample, place));
    }

    std::stable_sort (events.begin(), events.end(),
                      [] (const TimedEvent& a, const TimedEvent& b) { return a.sample < b.sample; });
    return events;
}

/** How often playing asks for memory, with all voices, while banks change.
    @param bank  a bank with so many places filled */
template <typename MakeBank>
long allocationsWhilePlaying (const MakeBank& bank)
{
    FocusPlayer player (playerCeramics, playerRate, {});
    player.handOver().give (bank (FocusBank::places));
    std::vector<std::vector<double>> buffers (playerCeramics, std::vector<double> (64));
    std::vector<double*> channels;

    for (auto& buffer : buffers)
        channels.push_back (buffer.data());

    long calls = 0;

    for (int block = 0; block < 400; ++block)
    {
        if (block % 40 == 0)
            player.handOver().give (bank (8));

        const FocusEvent events[] { { 3, FocusEventKind::trigger, block % 8, 0.5 },
                                    { 40, FocusEventKind::release, block % 8, 0 } };
        const auto before = mallocCalls();
        player.process (channels.data(), 64, events);
        calls += mallocCalls() - before;
    }

    return calls;
}
} // namespace antinode::test
