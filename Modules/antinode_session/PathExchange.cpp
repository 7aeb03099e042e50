#include "PathExchange.h"

namespace antinode
{
PathExchange::~PathExchange()
{
    delete next.load();
    delete retired.load();
    delete playing;
}

void PathExchange::give (std::unique_ptr<AudioPath> path)
{
    collect();
    delete next.exchange (path.release(), std::memory_order_acq_rel);
}

void PathExchange::collect()
{
    delete retired.exchange (nullptr, std::memory_order_acq_rel);
}

AudioPath* PathExchange::current (double sampleRate, int count)
{
    const auto isUsable = [&] { return playing != nullptr && playing->sampleRate() == sampleRate; };

    if (next.load (std::memory_order_acquire) != nullptr && retired.load (std::memory_order_acquire) == nullptr)
    {
        const auto mayGo = ! isUsable() || isResting || (isLeaving() && playing->isSilentAfter (leavingSamples));

        if (mayGo)
        {
            retired.store (playing, std::memory_order_release);
            playing = next.exchange (nullptr, std::memory_order_acq_rel);
        }

        leavingSamples = mayGo ? -1 : (isLeaving() ? leavingSamples + count : 0);
    }

    isResting = false;
    return isUsable() ? playing : nullptr;
}

void PathExchange::reset()
{
    if (playing != nullptr)
        playing->reset();

    isResting = true;
}
} // namespace antinode
