#pragma once

#include <antinode_documents/Library.h>
#include <antinode_session/FocusSettings.h>

#include <Plate/PlateProcessor.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace antinode::test
{
inline std::shared_ptr<const DeviceDocument> plateDevice (const std::string& name)
{
    return std::make_shared<const DeviceDocument> (
        readDeviceDocument (loadDocument (LibraryKind::device, name), "device '" + name + "'"));
}

/** A processor as an offline host has it: its device solved, never a silent first block. */
inline std::unique_ptr<PlateProcessor> offlinePlate (int ceramics, double sampleRate, int block)
{
    auto processor = std::make_unique<PlateProcessor> (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor->setNonRealtime (true);
    processor->setRateAndBufferSizeDetails (sampleRate, block);
    processor->prepareToPlay (sampleRate, block);
    processor->session().waitUntilSettled();
    return processor;
}

/** Lets voltages move the surface. @param voltages  ceramics x samples, full scale 1 @return  8 probes x samples */
template <typename Sample = double>
Eigen::MatrixXd moved (PlateProcessor& processor, const Eigen::MatrixXd& voltages, int block)
{
    const auto channels = std::max (processor.getTotalNumInputChannels(), processor.getTotalNumOutputChannels());
    const auto probes = processor.getTotalNumOutputChannels();
    const auto samples = static_cast<int> (voltages.cols());
    Eigen::MatrixXd played (probes, samples);
    juce::MidiBuffer midi;

    for (int done = 0; done < samples; done += block)
    {
        const auto count = std::min (block, samples - done);
        juce::AudioBuffer<Sample> buffer (channels, count);
        buffer.clear();

        for (int i = 0; i < std::min (static_cast<int> (voltages.rows()), processor.getTotalNumInputChannels()); ++i)
            for (int n = 0; n < count; ++n)
                buffer.setSample (i, n, static_cast<Sample> (voltages (i, done + n)));

        processor.processBlock (buffer, midi);

        for (int i = 0; i < probes; ++i)
            for (int n = 0; n < count; ++n)
                played (i, done + n) = static_cast<double> (buffer.getSample (i, n));
    }

    return played;
}

/** A sine on every ceramic, each of another frequency. */
inline Eigen::MatrixXd sines (int ceramics, int samples, double amplitude = 0.2)
{
    Eigen::MatrixXd voltages (ceramics, samples);

    for (int i = 0; i < ceramics; ++i)
        for (int n = 0; n < samples; ++n)
            voltages (i, n) = amplitude * std::sin (0.02 * n * (i + 1));

    return voltages;
}
} // namespace antinode::test
