#include "BufferChannels.h"

#include "VST3Channels.h"

namespace antinode
{
void BufferChannels::lay (const juce::AudioProcessor& processor, juce::AudioProcessor::WrapperType wrapper)
{
    const auto layout = processor.getBus (false, 0)->getCurrentLayout();
    ceramicOrder = wireOrder (layout, wrapper);
    firstMonitor = layout.size();
    monitors = processor.getChannelCountOfBus (false, 1);
    hasSensor = processor.getTotalNumInputChannels() > 0;
}

template <typename Sample>
std::optional<OutputBlock<Sample>> BufferChannels::makeBlock (juce::AudioBuffer<Sample>& buffer,
                                                              Pointers<Sample>& pointers) const
{
    const auto wires = static_cast<int> (ceramicOrder.size());

    if (buffer.getNumChannels() < wires + monitors)
        return std::nullopt;

    for (std::size_t k = 0; k < ceramicOrder.size(); ++k)
        pointers.ceramics[k] = buffer.getWritePointer (ceramicOrder[k]);

    for (int i = 0; i < monitors; ++i)
        pointers.monitor[static_cast<std::size_t> (i)] = buffer.getWritePointer (firstMonitor + i);

    for (auto i = wires + monitors; i < buffer.getNumChannels(); ++i)
        buffer.clear (i, 0, buffer.getNumSamples());

    return OutputBlock<Sample> { { pointers.ceramics.data(), ceramicOrder.size() },
                                 { pointers.monitor.data(), static_cast<std::size_t> (monitors) },
                                 buffer.getNumSamples(),
                                 hasSensor ? buffer.getReadPointer (0) : nullptr };
}

template std::optional<OutputBlock<float>> BufferChannels::makeBlock (juce::AudioBuffer<float>&,
                                                                      Pointers<float>&) const;
template std::optional<OutputBlock<double>> BufferChannels::makeBlock (juce::AudioBuffer<double>&,
                                                                       Pointers<double>&) const;
} // namespace antinode
