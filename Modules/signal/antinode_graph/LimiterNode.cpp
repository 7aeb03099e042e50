#include "LimiterNode.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
LimiterNode::LimiterNode (const Eigen::VectorXd& limits)
    : channels (static_cast<int> (limits.size())), focusLimits (static_cast<std::size_t> (channels)),
      voltageLimiter (limits)
{
    setFocusLimits (limits);
}

void LimiterNode::setFocusLimits (const Eigen::VectorXd& volts)
{
    for (Eigen::Index i = 0; i < channels; ++i)
        focusLimits[static_cast<std::size_t> (i)] = volts[i];
}

void LimiterNode::prepare (const NodeFormat& format)
{
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * format.sampleRate));
    isArmed = wantsArmed.load();
    ramp = SafetyRamp (isArmed ? 1 : 0);
}

void LimiterNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
        std::copy (block.inputs[i], block.inputs[i] + block.count, block.outputs[i]);

    if (const auto wanted = wantsArmed.load (std::memory_order_relaxed); wanted != isArmed)
    {
        isArmed = wanted;
        ramp.setTarget (isArmed ? 1 : 0, rampSamples);
    }

    ramp.process (block.outputs, channels, block.count);

    const auto ofAll = wantedLimit.load (std::memory_order_relaxed);

    for (std::size_t i = 0; i < focusLimits.size(); ++i)
        voltageLimiter.setFurtherLimit (i, std::min (ofAll, focusLimits[i].load (std::memory_order_relaxed)));

    voltageLimiter.process (block.outputs, block.count);
}
} // namespace antinode
