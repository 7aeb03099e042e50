#pragma once

#include <cstdint>

namespace antinode
{
/** Whether an audio device still calls: one that has gone says nothing, and what else it says is not to be trusted. */
class DeviceWatch
{
public:
    using Milliseconds = std::uint32_t; ///< Of a clock that may wrap.

    static constexpr Milliseconds patience = 3000; ///< Without a call.

    /** A device has been opened. [message thread] as all that follows */
    void begin (Milliseconds now)
    {
        seenAt = now;
        watches = true;
        stopped = false;
    }

    /** It has been closed. */
    void end() { watches = stopped = false; }

    /** Looks. @param samples  that were played since the start @return  whether hasStopped() has changed */
    bool look (std::int64_t samples, Milliseconds now)
    {
        const auto before = stopped;

        if (samples != seenSamples)
        {
            seenSamples = samples;
            seenAt = now;
        }

        stopped = watches && now - seenAt > patience;
        return stopped != before;
    }

    bool hasStopped() const { return stopped; }

private:
    std::int64_t seenSamples = 0;
    Milliseconds seenAt = 0;
    bool watches = false, stopped = false;
};
} // namespace antinode
