#pragma once

#include <juce_core/juce_core.h>

#include <string>

namespace antinode::test
{
enum class PluginKind
{
    vst3,
    lv2
};

/** What the plug-in itself keeps, out of what the host wraps around it. */
std::string innerState (PluginKind, const juce::MemoryBlock&);

/** A host's state with other contents. @param like  a state of the same plug-in */
juce::MemoryBlock hostState (PluginKind, const juce::MemoryBlock& like, const std::string& inner);
} // namespace antinode::test
