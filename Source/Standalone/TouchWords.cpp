#include "TouchWords.h"

#include <numeric>

namespace antinode
{
namespace
{
juce::String portInWords (int port)
{
    return port > 0 ? "on port " + juce::String (port) : juce::String ("off");
}
} // namespace

juce::String portsInWords (const TouchPorts& open)
{
    return "OSC " + portInWords (open.oscPort) + ", TUIO " + portInWords (open.tuioPort);
}

juce::String packetsInWords (const TouchCounters& counters)
{
    return juce::String (counters.packets) + " packets, " + juce::String (counters.touches) + " touches forwarded";
}

std::int64_t faultCount (const TouchCounters& counters)
{
    return std::accumulate (counters.faults.begin(), counters.faults.end(), std::int64_t());
}
} // namespace antinode
