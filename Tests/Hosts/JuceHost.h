#pragma once

#include "HostState.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode::test
{
/** A built plug-in: what a test is to be repeated with. */
struct BuiltPlugin
{
    PluginKind kind = PluginKind::vst3;
    int ceramics = 8; ///< Of the LV2 bundle, or what ANTINODE_CERAMICS says to the VST3.
};

std::string pluginName (const BuiltPlugin&);

/** All LV2 bundles, and the VST3 with 2, 8, 16, 32 and 64 channels. */
std::vector<BuiltPlugin> builtPlugins();

/** The VST3 and the last LV2, of as many ceramics. */
std::vector<BuiltPlugin> builtPair();

/** An instance in JUCE's own hosting. @throws std::runtime_error  with the host's reason [main thread] */
std::unique_ptr<juce::AudioPluginInstance> hosted (const BuiltPlugin&, double rate = 48000, int block = 512);

/** The same, offline and prepared. */
std::unique_ptr<juce::AudioPluginInstance> hostedOffline (const BuiltPlugin&, double rate = 48000, int block = 512);

/** Plays blocks. @return  ceramics in their order, then monitors, x samples: a JUCE host orders the wires of a VST3
   anew, which is undone here */
Eigen::MatrixXd play (juce::AudioPluginInstance&, const BuiltPlugin&, int samples, int block,
                      const std::function<void (int start, juce::MidiBuffer&)>& beforeBlock);

/** The same with one note. @param noteAt  below 0: none */
Eigen::MatrixXd play (juce::AudioPluginInstance&, const BuiltPlugin&, int samples, int block, int noteAt,
                      int note = 60);

juce::MemoryBlock savedState (juce::AudioPluginInstance&);
void setState (juce::AudioPluginInstance&, const juce::MemoryBlock&);

/** Plays until the host of a VST3 was told of all steps that its values became, and has sent them back: it would send
   them after a state, too. [main thread] @throws std::runtime_error  where that takes more than 10 s */
void waitForSteps (juce::AudioPluginInstance&, const BuiltPlugin&);

/** Runs work on another thread while this one answers messages. [main thread] */
void runInBackground (const std::function<void()>&);
} // namespace antinode::test
