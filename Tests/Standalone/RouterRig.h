#pragma once

#include <Standalone/OutputRouter.h>

#include <algorithm>
#include <vector>

namespace antinode::test
{
using Channels = std::vector<std::vector<float>>;

inline std::vector<const float*> pointersTo (const Channels& channels, int offset)
{
    std::vector<const float*> pointers;

    for (const auto& channel : channels)
        pointers.push_back (channel.data() + offset);

    return pointers;
}

inline Channels constant (int channels, int count, float value)
{
    return Channels (static_cast<std::size_t> (channels), std::vector<float> (static_cast<std::size_t> (count), value));
}

/** A router between ceramics and outputs that are vectors. */
struct RouterRig
{
    static constexpr double rate = 48000, fullScale = 150;
    static constexpr int rampSamples = 240;

    RouterRig() { router.prepare (rate); }

    void route (const OutputRouting& routing, const std::vector<double>& limits = {})
    {
        router.setRouting (routing, limits);
        router.prepare (rate);
    }

    /** What so many outputs give, where the blocks have these lengths in turn. */
    Channels play (const Channels& ceramics, int outputs, std::vector<int> blocks = { 1 << 20 },
                   const Channels& monitor = {})
    {
        const auto count = static_cast<int> (ceramics.front().size());
        auto played = constant (outputs, count, 7);
        std::size_t next = 0;

        for (int offset = 0, part = 0; offset < count; offset += part)
        {
            part = std::min (blocks[next++ % blocks.size()], count - offset);
            std::vector<float*> channels;

            for (auto& channel : played)
                channels.push_back (channel.data() + offset);

            router.process (
                { pointersTo (ceramics, offset), pointersTo (monitor, offset), channels, part, fullScale, isArmed });
        }

        return played;
    }

    OutputRouter router;
    bool isArmed = true;
};
} // namespace antinode::test
