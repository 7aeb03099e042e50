#pragma once

#include "EngineFixtures.h"

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

struct TimedEvent
{
    std::int64_t sample = 0;
    FocusEvent event;
};

/** Plays events in blocks of the given sizes, over and over, and returns all samples: channels x length. */
template <typename Sample = double>
Eigen::MatrixXd played (FocusPlayer& player, const std::vector<TimedEvent>& timed, Eigen::Index length,
                        const std::vector<int>& blocks)
{
    Eigen::MatrixXd result (playerCeramics, length);
    std::vector<std::vector<Sample>> buffers (playerCeramics);
    std::size_t next = 0, block = 0;

    for (Eigen::Index start = 0; start < length; ++block)
    {
        const auto count = static_cast<int> (std::min<Eigen::Index> (blocks[block % blocks.size()], length - start));
        std::vector<FocusEvent> events;
        std::vector<Sample*> channels;

        for (; next < timed.size() && timed[next].sample < start + count; ++next)
        {
            events.push_back (timed[next].event);
            events.back().offset = static_cast<int> (timed[next].sample - start);
        }

        for (auto& buffer : buffers)
        {
            buffer.assign (static_cast<std::size_t> (count), Sample (77));
            channels.push_back (buffer.data());
        }

        player.process (channels.data(), count, events);

        for (int i = 0; i < playerCeramics; ++i)
            for (int n = 0; n < count; ++n)
                result (i, start + n) =
                    static_cast<double> (buffers[static_cast<std::size_t> (i)][static_cast<std::size_t> (n)]);

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
} // namespace antinode::test
