#include "Interruption.h"

#include <antinode_base/System.h>

#include <atomic>
#include <chrono>
#include <cstdint>

namespace antinode
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr Clock::duration longestRamp = std::chrono::seconds (1); // until a device has played it

// Of a handler: nothing else is safe there.
std::atomic<int> arrived { 0 }, answered { 0 };
std::atomic<std::uint64_t> seen { 0 }; // bit k: signal k
std::atomic<Clock::rep> arrivedAt { 0 };
std::atomic<bool> mayBeDriving { false };

void note (int signal)
{
    const auto kind = std::uint64_t { 1 } << signal;
    const auto now = Clock::now().time_since_epoch().count();

    if ((seen.fetch_or (kind) & kind) == 0)
    {
        if (! isInterrupted())
            arrivedAt = now;

        arrived = signal;
    }
    else if (! (mayBeDriving && isInterrupted() && now - arrivedAt < longestRamp.count()))
    {
        endBySignal (signal);
    }
}
} // namespace

void catchInterruptions()
{
    handleEndingSignals (note);
}

void protectRamps()
{
    mayBeDriving = true;
    handleBrokenPipes (note);
}

bool isInterrupted()
{
    return arrived != answered;
}

void answerInterruption()
{
    answered = arrived.load();
}

int interruptingSignal()
{
    return arrived;
}
} // namespace antinode
