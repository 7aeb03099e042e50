#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace antinode
{
/** Paths on their way from the session to the audio thread and back: one atomic exchange each way. A path that
    plays ramps to rest before the next one takes its place.
    @tparam Path  has sampleRate(), reset() and isSilentAfter (samples): whether the ramp that began so long ago has
        ended */
template <typename Path>
class PathExchange
{
public:
    PathExchange() = default;

    /** Frees everything; nothing may be playing. [worker] */
    ~PathExchange() { clear(); }

    PathExchange (const PathExchange&) = delete;
    PathExchange& operator= (const PathExchange&) = delete;

    /** Hands a path over and frees what came back. One that was not taken yet is replaced. [worker] */
    void give (std::unique_ptr<Path> path)
    {
        collect();
        delete next.exchange (path.release(), std::memory_order_acq_rel);
    }

    /** Frees what came back. [worker] */
    void collect() { delete retired.exchange (nullptr, std::memory_order_acq_rel); }

    /** Frees everything; nothing may be playing. [worker] */
    void clear()
    {
        delete next.exchange (nullptr);
        delete retired.exchange (nullptr);
        delete std::exchange (playing, nullptr);
    }

    /** The path for a block of so many samples, or none where there is none for this rate. [audio thread] */
    Path* current (double sampleRate, int count)
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

    /** Whether the current path has to ramp to rest, since another one waits. [audio thread] */
    bool isLeaving() const { return leavingSamples >= 0; }

    /** The path that plays comes to rest at once; one that waits takes its place with the next block, without a ramp.
        [audio thread, or while nothing plays] */
    void reset()
    {
        if (playing != nullptr)
            playing->reset();

        isResting = true;
    }

private:
    std::atomic<Path*> next { nullptr }, retired { nullptr };
    Path* playing = nullptr; ///< Of the audio thread, as the next line.
    std::int64_t leavingSamples = -1;
    bool isResting = false; ///< Whether nothing has played since the reset.
};
} // namespace antinode
