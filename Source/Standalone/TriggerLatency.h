#pragma once

#include "StandaloneHost.h"

namespace antinode
{
/** From a note to its focus, and what that is made of. s */
struct TriggerLatency
{
    double focusTime = 0; ///< From the trigger until the focus: the modes need it to build up.
    double block = 0;     ///< A note that arrives during a block is played with the next one.
    double output = 0;    ///< From a played sample until it is at the output, as the device's driver says.

    double whole() const { return focusTime + block + output; }
};

/** Of the open device and the focus that plays; none where one of them is missing. [message thread] Docs/Manual/
    latency.md */
std::optional<TriggerLatency> triggerLatency (StandaloneHost&);

/** "focus 36 ms after a note: 25 focus time, 5.3 block, 5.3 output". [any] */
juce::String latencyInWords (const TriggerLatency&);

/** How to lower the largest part. [any] */
juce::String latencyAdvice (const TriggerLatency&);
} // namespace antinode
