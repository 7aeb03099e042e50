#include "TriggerLatency.h"

#include <antinode_base/NumberText.h>
#include <antinode_focus/FocusMoments.h>

#include <algorithm>

namespace antinode
{
std::optional<TriggerLatency> triggerLatency (StandaloneHost& host)
{
    auto* const device = host.devices().getCurrentAudioDevice();
    const auto snapshot = host.processor().session().snapshot();

    if (device == nullptr || ! (device->getCurrentSampleRate() > 0) || snapshot == nullptr || snapshot->model == nullptr
        || snapshot->focus.targets.empty())
        return {};

    const auto rate = device->getCurrentSampleRate();
    return TriggerLatency { earliestFocusTime (snapshot->focus), device->getCurrentBufferSizeSamples() / rate,
                            std::max (0, device->getOutputLatencyInSamples()) / rate };
}

juce::String latencyInWords (const TriggerLatency& latency)
{
    const auto milliseconds = [] (double seconds) { return fixedText (seconds * 1000, 1); };
    return juce::String ("focus " + milliseconds (latency.whole())
                         + " ms after a note: " + milliseconds (latency.focusTime) + " focus time, "
                         + milliseconds (latency.block) + " block, " + milliseconds (latency.output) + " output");
}

juce::String latencyAdvice (const TriggerLatency& latency)
{
    const juce::String touch (" A touch is designed first, which takes the time of one design more: shortest with the "
                              "method exact and few modes.");

    if (latency.focusTime >= latency.block + latency.output)
        return "A shorter focus time lowers the latency most; it takes more voltage." + touch;

    return "A smaller block in Settings, Audio device, lowers the latency most; it takes more of the processor."
           + touch;
}
} // namespace antinode
