#pragma once

#include <antinode_documents/Library.h>

#include <Touch/TouchProcessor.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace antinode::test
{
inline std::shared_ptr<const DeviceDocument> touchDeviceFrom (const nlohmann::json& json)
{
    return std::make_shared<const DeviceDocument> (readDeviceDocument (json, "device"));
}

inline std::shared_ptr<const DeviceDocument> touchDevice (const std::string& name)
{
    return touchDeviceFrom (loadDocument (LibraryKind::device, name));
}

/** Two fingers that play and a silent one, far from each other. */
inline std::map<std::string, double> threeFingers()
{
    return { { "finger1_x", 25 }, { "finger1_y", 40 }, { "finger1_state", 2 }, { "finger1_level", 1 },
             { "finger2_x", 70 }, { "finger2_y", 65 }, { "finger2_state", 2 }, { "finger2_level", 0.5 },
             { "finger3_x", 55 }, { "finger3_y", 20 }, { "finger3_state", 1 } };
}

/** The channels of fingers and ceramics, without a sensor. */
inline juce::AudioProcessor::BusesLayout touchLayout (int fingers, int ceramics)
{
    juce::AudioProcessor::BusesLayout layout;
    layout.inputBuses.add (juce::AudioChannelSet::discreteChannels (fingers));
    layout.inputBuses.add (juce::AudioChannelSet::disabled());
    layout.outputBuses.add (juce::AudioChannelSet::discreteChannels (ceramics));
    return layout;
}

/** A processor as an offline host has it: its filters designed, never a silent first block. */
inline std::unique_ptr<TouchProcessor> offlineTouch (int ceramics, double sampleRate, int block,
                                                     const std::map<std::string, double>& parameters = threeFingers())
{
    auto processor = std::make_unique<TouchProcessor> (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor->setNonRealtime (true);
    processor->parameters().setValues (parameters);
    processor->setRateAndBufferSizeDetails (sampleRate, block);
    processor->prepareToPlay (sampleRate, block);
    processor->session().waitUntilSettled();
    return processor;
}

/** A note-on. */
struct PlayedNote
{
    int sample = 0, note = 60, velocity = 127;
};

/** The notes that fall into a block. */
inline juce::MidiBuffer notesWithin (const std::vector<PlayedNote>& notes, int first, int count)
{
    juce::MidiBuffer midi;

    for (const auto& each : notes)
        if (each.sample >= first && each.sample < first + count)
            midi.addEvent (juce::MidiMessage::noteOn (1, each.note, static_cast<juce::uint8> (each.velocity)),
                           each.sample - first);

    return midi;
}

/** Plays inputs and notes. @param inputs  fingers x samples @return  ceramics x samples, full scale 1 */
template <typename Sample = double>
Eigen::MatrixXd voltagesOf (TouchProcessor& processor, const Eigen::MatrixXd& inputs, int block,
                            const std::vector<PlayedNote>& notes = {})
{
    const auto channels = std::max (processor.getTotalNumInputChannels(), processor.getTotalNumOutputChannels());
    const auto ceramics = processor.getTotalNumOutputChannels();
    const auto samples = static_cast<int> (inputs.cols());
    Eigen::MatrixXd played (ceramics, samples);

    for (int done = 0; done < samples; done += block)
    {
        const auto count = std::min (block, samples - done);
        auto midi = notesWithin (notes, done, count);
        juce::AudioBuffer<Sample> buffer (channels, count);
        buffer.clear();

        for (int i = 0; i < std::min (static_cast<int> (inputs.rows()), processor.getTotalNumInputChannels()); ++i)
            for (int n = 0; n < count; ++n)
                buffer.setSample (i, n, static_cast<Sample> (inputs (i, done + n)));

        processor.processBlock (buffer, midi);

        for (int i = 0; i < ceramics; ++i)
            for (int n = 0; n < count; ++n)
                played (i, done + n) = static_cast<double> (buffer.getSample (i, n));
    }

    return played;
}

/** For each finger tones of its own within the band that fade in and out, largest 1. */
inline Eigen::MatrixXd fingerTones (int fingers, int samples, double sampleRate, double amplitude = 1)
{
    Eigen::MatrixXd tones (fingers, samples);

    for (int k = 0; k < fingers; ++k)
        for (int n = 0; n < samples; ++n)
        {
            const auto time = n / sampleRate;
            const auto envelope = std::pow (std::sin (std::numbers::pi * n / samples), 2);
            const auto tone = 0.5 * std::sin (2 * std::numbers::pi * (130 + 57 * k) * time)
                              + 0.5 * std::sin (2 * std::numbers::pi * (310 + 83 * k) * time + k);
            tones (k, n) = amplitude * envelope * tone;
        }

    return tones;
}
} // namespace antinode::test
