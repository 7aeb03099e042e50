#pragma once

#include "MidiTriggers.h"
#include "Node.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>
#include <vector>

namespace antinode
{
/** A node as a juce::AudioProcessor, with a bus of its inputs and one of its outputs: for a juce::AudioProcessorGraph,
   or to be loaded on its own. The real-time path of Antinode is NodeGraph, with the same nodes and the same samples. */
class NodeProcessor : public juce::AudioProcessor
{
public:
    explicit NodeProcessor (std::unique_ptr<Node>, VelocityCurve curve = {});

    Node& node() { return *wrapped; }

    const juce::String getName() const override { return wrapped->name(); }
    void prepareToPlay (double sampleRate, int longestBlock) override;
    void releaseResources() override {}
    bool supportsDoublePrecisionProcessing() const override { return true; }
    bool isBusesLayoutSupported (const BusesLayout&) const override;
    void processBlock (juce::AudioBuffer<float>&, juce::MidiBuffer&) override;
    void processBlock (juce::AudioBuffer<double>&, juce::MidiBuffer&) override;
    double getTailLengthSeconds() const override { return 0; }
    bool acceptsMidi() const override { return wrapped->inputs() == 0; }
    bool producesMidi() const override { return false; }
    juce::AudioProcessorEditor* createEditor() override { return nullptr; }
    bool hasEditor() const override { return false; }
    int getNumPrograms() override { return 1; }
    int getCurrentProgram() override { return 0; }
    void setCurrentProgram (int) override {}
    const juce::String getProgramName (int) override { return {}; }
    void changeProgramName (int, const juce::String&) override {}
    void getStateInformation (juce::MemoryBlock&) override {}
    void setStateInformation (const void*, int) override {}

private:
    static BusesProperties makeBuses (const Node&);
    template <typename Sample>
    void processParts (juce::AudioBuffer<Sample>&, juce::AudioBuffer<Sample>& inputs, const juce::MidiBuffer&);

    std::unique_ptr<Node> wrapped;
    MidiTriggers triggers;
    int longestPart = 1; ///< Samples.
    std::vector<FocusEvent> partEvents;
    juce::AudioBuffer<float> inputFloats;
    juce::AudioBuffer<double> inputDoubles;
};
} // namespace antinode
