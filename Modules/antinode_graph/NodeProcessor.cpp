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
    wrapped->prepare ({ sampleRate, longestBlock });
    inputFloats.setSize (wrapped->inputs(), longestBlock);
    inputDoubles.setSize (wrapped->inputs(), longestBlock);
    setLatencySamples (static_cast<int> (wrapped->latencySamples()));
}

bool NodeProcessor::isBusesLayoutSupported (const BusesLayout& layout) const
{
    return layout.getMainInputChannels() == wrapped->inputs() && layout.getMainOutputChannels() == wrapped->outputs();
}

template <typename Sample>
void NodeProcessor::processParts (juce::AudioBuffer<Sample>& buffer, juce::AudioBuffer<Sample>& inputs,
                                  const juce::MidiBuffer& midi)
{
    const auto count = buffer.getNumSamples();

    // JUCE hands inputs and outputs over in the same channels.
    if (buffer.getNumChannels() < std::max (wrapped->inputs(), wrapped->outputs())
        || (wrapped->inputs() > 0 && count > inputs.getNumSamples()))
    {
        buffer.clear();
        return;
    }

    for (int i = 0; i < wrapped->inputs(); ++i)
        inputs.copyFrom (i, 0, buffer, i, 0, count);

    wrapped->process (NodeBlock<Sample> { inputs.getArrayOfReadPointers(), buffer.getArrayOfWritePointers(), count,
                                          triggers.read (midi, count) });
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
