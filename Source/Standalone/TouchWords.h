#pragma once

#include <antinode_touch/TouchCounters.h>
#include <antinode_touch/TouchPorts.h>

#include <juce_core/juce_core.h>

#include <cstdint>

namespace antinode
{
/** "OSC on port 9000, TUIO off". [any] */
juce::String portsInWords (const TouchPorts& open);

/** "12 packets, 10 touches forwarded". [any] */
juce::String packetsInWords (const TouchCounters&);

/** Of all kinds together. [any] */
std::int64_t faultCount (const TouchCounters&);
} // namespace antinode
