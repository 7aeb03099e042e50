#pragma once

#include <TouchProcessor/TouchProcessor.h>

namespace antinode
{
/** What Antinode Touch does just now that somebody has to wait for or to know, in one sentence; empty where it simply
    plays. [message thread] */
juce::String touchSentence (TouchProcessor&, const TouchSnapshot&);
} // namespace antinode
