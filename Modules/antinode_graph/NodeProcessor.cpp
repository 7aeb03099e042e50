#include "NodeProcessor.h"

namespace antinode
{
NodeProcessor::NodeProcessor (std::unique_ptr<Node> node, VelocityCurve curve)
    : AudioProcessor (makeBuses (*node)), wrapped (std::move (node)), triggers (curve)
{
}

juce::AudioProcessor::BusesProperties NodeProcessor::makeBuses (const Node& node)
{
    BusesProperties buses;

    if (node.inputs() > 0)
        buses.addBus (true, "Input", juce::AudioChannelSet::discreteChannels (node.inputs()));

    buses.addBus (false, "Output", juce::AudioChannelSet::discreteChannels (node.outputs()));
    return buses;
}

void NodeProcessor::prepareToPlay (double sampleRate, int longestBlock)
{
    longestPart = std::max (1, longestBlock);
    wrapped->prepare ({ sampleRate, longestPart });
    inputFloats.setSize (wrapped->inputs(), longestPart);
    inputDoubles.setSize (wrapped->inputs(), longestPart);
    partEvents.reserve (MidiTriggers::mostEvents);
    setLatencySamples (static_cast<int> (wrapped->latencySamples()));
}

bool NodeProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    return layout.getMainInputChannels() == wrapped->inputs() && layout.getMainOutputChannels() == wrapped->outputs();
}

/** No part is longer than the node was prepared for. */
template <typename Sample>
void NodeProcessor::processParts (juce::AudioBuffer<Sample>& buffer, juce::AudioBuffer<Sample>& inputs,
                                  const juce::MidiBuffer& midi)
{
    // JUCE hands inputs and outputs over in the same channels.
    if (buffer.getNumChannels() < std::max (wrapped->inputs(), wrapped->outputs()))
    {
        buffer.clear();
        return;
    }

    auto events = triggers.read (midi, buffer.getNumSamples());

    int offset = 0;

    do
    {
        const auto count = std::min (longestPart, buffer.getNumSamples() - offset);

        for (int i = 0; i < wrapped->inputs(); ++i)
            inputs.copyFrom (i, 0, buffer, i, offset, count);

        partEvents.clear();

        for (; ! events.empty() && events.front().offset < offset + std::max (1, count); events = events.subspan (1))
        {
            partEvents.push_back (events.front());
            partEvents.back().offset -= offset;
        }

        juce::AudioBuffer<Sample> part (buffer.getArrayOfWritePointers(), buffer.getNumChannels(), offset, count);
        wrapped->process (
            NodeBlock<Sample> { inputs.getArrayOfReadPointers(), part.getArrayOfWritePointers(), count, partEvents });
        offset += longestPart;
    } while (offset < buffer.getNumSamples());
}

void NodeProcessor::processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi)
{
    processParts (buffer, inputFloats, midi);
}

void NodeProcessor::processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi)
{
    processParts (buffer, inputDoubles, midi);
}
} // namespace antinode
