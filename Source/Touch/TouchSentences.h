#pragma once

#include "TouchProcessor.h"

#include <optional>
#include <vector>

namespace antinode
{
/** What Antinode Touch does just now that somebody has to wait for or to know; empty where it simply plays. [message
    thread] */
std::vector<UserMessage> touchSentences (TouchProcessor&, const TouchSnapshot&);

/** The voltage, V, of the ceramic with most where every finger that plays gets noise that fills the band and whose
    largest samples, three times its RMS, are 1.0; none where there are no filters for that latency yet. [any] */
std::optional<double> noiseVolts (const TouchSnapshot&, const PlayControls&, std::size_t latency);

/** The same for all latencies, in words. [any] */
juce::String latencyVoltsText (const TouchSnapshot&, const PlayControls&);
} // namespace antinode
