#include "ChannelGainNode.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
ChannelGainNode::ChannelGainNode (int channelsToUse)
    : channels (channelsToUse), targets (static_cast<std::size_t> (channelsToUse), 1.0),
      ramps (static_cast<std::size_t> (channelsToUse), SafetyRamp (1))
{
}

double ChannelGainNode::targetGain (int channel) const
{
    const auto isMuted = channel < 64 && ((wantedMutes.load (std::memory_order_relaxed) >> channel) & 1U) != 0;
    return isMuted ? 0.0 : wantedGain.load (std::memory_order_relaxed);
}

void ChannelGainNode::prepare (const NodeFormat& format)
{
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * format.sampleRate));

    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);
        targets[channel] = targetGain (i);
        ramps[channel] = SafetyRamp (targets[channel]);
    }
}

void ChannelGainNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);
        std::copy (block.inputs[i], block.inputs[i] + block.count, block.outputs[i]);

        if (const auto target = targetGain (i); target != targets[channel])
        {
            targets[channel] = target;
            ramps[channel].setTarget (target, rampSamples);
        }

        if (ramps[channel].isMoving() || ramps[channel].gain() != 1)
            ramps[channel].process (block.outputs + i, 1, block.count);
    }
}
} // namespace antinode
