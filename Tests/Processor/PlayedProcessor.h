#pragma once

#include <Processor/AntinodeProcessor.h>
#include <antinode_engine/VoltageSynthesiser.h>
#include <antinode_focus/DesignFocus.h>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace antinode::test
{
/** A processor as an offline host has it: prepared, never a silent first block. */
inline std::unique_ptr<AntinodeProcessor> offlineProcessor (int ceramics, double sampleRate, int block)
{
    auto processor = std::make_unique<AntinodeProcessor> (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor->setNonRealtime (true);
    processor->setRateAndBufferSizeDetails (sampleRate, block);
    processor->prepareToPlay (sampleRate, block);
    processor->session().waitUntilSettled();
    return processor;
}

/** Plays so many samples with a note at one of them. @return  channels x samples, 1.0 = full scale */
inline Eigen::MatrixXd play (AntinodeProcessor& processor, int samples, int block, int noteAt, int note = 60,
                             int velocity = 127, const std::function<void (int block)>& beforeBlock = {})
{
    const auto channels = processor.getTotalNumOutputChannels();
    Eigen::MatrixXd played (channels, samples);

    for (int done = 0; done < samples; done += block)
    {
        const auto count = std::min (block, samples - done);
        juce::AudioBuffer<double> buffer (channels, count);
        juce::MidiBuffer midi;

        if (noteAt >= done && noteAt < done + count)
            midi.addEvent (juce::MidiMessage::noteOn (1, note, static_cast<juce::uint8> (velocity)), noteAt - done);

        if (beforeBlock)
            beforeBlock (done / block);

        processor.processBlock (buffer, midi);

        for (int i = 0; i < channels; ++i)
            played.row (i).segment (done, count) =
                Eigen::Map<const Eigen::RowVectorXd> (buffer.getReadPointer (i), count);
    }

    return played;
}

/** What the command line renders for a focus, in full scales. @return  N_b x samples */
inline Eigen::MatrixXd renderedFocus (const ModalModel& model, const FocusDescription& focus, double sampleRate,
                                      int samples)
{
    const Playback playback { Reconstruction::bandLimited, sampleRate };
    const auto design = designFocus (model, focus, playback);
    Eigen::MatrixXd voltages (model.actuators(), samples);
    VoltageSynthesiser (design.program, playback).process (0, voltages);
    return voltages / model.fullScaleVoltage;
}

inline Eigen::MatrixXd renderedDemonstrator (const ModalModel& model, double sampleRate, int samples)
{
    return renderedFocus (model, demonstrator().focus->description, sampleRate, samples);
}
} // namespace antinode::test
