#pragma once

#include <Plate/PlateProcessor.h>
#include <Processor/AntinodeProcessor.h>
#include <Touch/TouchProcessor.h>
#include <antinode_documents/Library.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>

namespace antinode::test
{
template <typename Processor>
std::unique_ptr<Processor> makeRole (int ceramics = 8)
{
    return std::make_unique<Processor> (ceramics, juce::AudioProcessor::wrapperType_Undefined);
}

template <typename Processor>
void prepareRole (Processor& processor, double rate = 48000)
{
    processor.setRateAndBufferSizeDetails (rate, 512);
    processor.prepareToPlay (rate, 512);
    processor.session().waitUntilSettled();
}

/** A processor as an offline host has it: never a silent first block. */
template <typename Processor>
std::unique_ptr<Processor> offlineRole (int ceramics = 8)
{
    auto processor = makeRole<Processor> (ceramics);
    processor->setNonRealtime (true);
    prepareRole (*processor);
    return processor;
}

/** Plays middle C at the first sample and a sine at each input. @return  outputs x samples */
template <typename Sample = double>
Eigen::MatrixXd playedRole (DeviceProcessor& processor, int samples, int block = 64)
{
    const auto inputs = processor.getTotalNumInputChannels(), outputs = processor.getTotalNumOutputChannels();
    Eigen::MatrixXd played (outputs, samples);

    for (int done = 0; done < samples; done += block)
    {
        const auto count = std::min (block, samples - done);
        juce::AudioBuffer<Sample> buffer (std::max (inputs, outputs), count);
        juce::MidiBuffer midi;
        buffer.clear();

        if (done == 0)
            midi.addEvent (juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)), 0);

        for (int i = 0; i < inputs; ++i)
            for (int n = 0; n < count; ++n)
                buffer.setSample (i, n, static_cast<Sample> (0.2 * std::sin (0.02 * (done + n) * (i + 1))));

        processor.processBlock (buffer, midi);

        for (int i = 0; i < outputs; ++i)
            for (int n = 0; n < count; ++n)
                played (i, done + n) = static_cast<double> (buffer.getSample (i, n));
    }

    return played;
}

inline std::shared_ptr<const DeviceDocument> deviceFrom (const nlohmann::json& json)
{
    return std::make_shared<const DeviceDocument> (readDeviceDocument (json, "device"));
}

template <typename Processor>
void loadDevice (Processor& processor, const nlohmann::json& json)
{
    if constexpr (std::is_same_v<Processor, AntinodeProcessor>)
        processor.load (deviceFrom (json), nullptr);
    else
        processor.load (deviceFrom (json));
}

inline std::string stateText (DeviceProcessor& processor)
{
    juce::MemoryBlock state;
    processor.getStateInformation (state);
    return state.toString().toStdString();
}

inline void setStateText (DeviceProcessor& processor, const std::string& text)
{
    processor.setStateInformation (text.data(), static_cast<int> (text.size()));
}
} // namespace antinode::test
