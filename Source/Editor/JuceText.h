#pragma once

#include <juce_core/juce_core.h>

#include <string>

namespace antinode
{
/** UTF-8 as text for JUCE. [any] */
juce::String fromUtf8 (const std::string& text);
} // namespace antinode
