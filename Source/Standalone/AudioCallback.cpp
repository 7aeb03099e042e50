#include "AudioCallback.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int longestPart = 1024;          // samples that the processor gets at once
constexpr std::size_t maximumNotes = 4096; // of one block that there is room for
constexpr int processorChannels = AntinodeProcessor::maximumCeramics + OutputRouting::monitors;
} // namespace

AudioCallback::AudioCallback (AntinodeProcessor& processorToPlay, OutputRouter& routerToUse, MidiQueue& queueToRead)
    : processor (processorToPlay), router (routerToUse), queue (queueToRead)
{
    notes.ensureSize (MidiQueue::bytesNeeded (maximumNotes));
    partNotes.ensureSize (MidiQueue::bytesNeeded (maximumNotes));
}

void AudioCallback::audioDeviceAboutToStart (juce::AudioIODevice* device)
{
    prepare (device->getCurrentSampleRate(), device->getCurrentBufferSizeSamples(), device->getActiveOutputChannels(),
             device->getActiveInputChannels());
}

void AudioCallback::prepare (double sampleRate, int blockSize, const juce::BigInteger& openOutputs,
                             const juce::BigInteger& openInputs)
{
    firstInput = openInputs.findNextSetBit (0);
    openChannels = 0;

    for (auto output = openOutputs.findNextSetBit (0); output >= 0 && output < OutputRouting::maximumOutputs;
         output = openOutputs.findNextSetBit (output + 1))
        numbers[static_cast<std::size_t> (openChannels++)] = output;

    buffer.setSize (processorChannels, longestPart);
    processor.setRateAndBufferSizeDetails (sampleRate, std::min (blockSize, longestPart));
    processor.prepareToPlay (sampleRate, std::min (blockSize, longestPart));
    router.prepare (sampleRate);
    rate = sampleRate;
}

void AudioCallback::audioDeviceStopped()
{
    rate = 0;
    firstInput = -1;
    processor.releaseResources();
}

void AudioCallback::audioDeviceError (const juce::String& message)
{
    const juce::ScopedLock lock (errors);
    lastError = message;
}

juce::String AudioCallback::takeError()
{
    const juce::ScopedLock lock (errors);
    return std::exchange (lastError, {});
}

void AudioCallback::audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                                      int outputCount, int count,
                                                      const juce::AudioIODeviceCallbackContext&)
{
    if (inputCount > 0 && inputs[0] != nullptr)
        inputTap.write (inputs[0], count);

    channels.fill (nullptr);

    for (int i = 0; i < outputCount; ++i)
        if (i < openChannels)
            channels[static_cast<std::size_t> (numbers[static_cast<std::size_t> (i)])] = outputs[i];
        else if (outputs[i] != nullptr)
            std::fill_n (outputs[i], count, 0.0F);

    gatherNotes (count);

    for (int offset = 0; offset < count; offset += longestPart)
        playPart (offset, std::min (longestPart, count - offset));

    played += count;
}

/** The notes of a block, in the order of their samples. */
void AudioCallback::gatherNotes (int count)
{
    notes.clear();
    queue.pop (notes, juce::Time::getMillisecondCounterHiRes(), rate, count);

    if (scheduleWanted.exchange (false))
    {
        schedule.rewind();
        schedulePosition = 0;
    }

    if (schedulePosition >= 0)
    {
        schedule.addTo (notes, schedulePosition, count, rate);
        schedulePosition += count;
    }
}

void AudioCallback::playPart (int offset, int count)
{
    buffer.setSize (processorChannels, count, false, false, true);
    buffer.clear();
    partNotes.clear();
    partNotes.addEvents (notes, offset, count, -offset);
    processor.processBlock (buffer, partNotes);

    for (std::size_t i = 0; i < channels.size(); ++i)
        partChannels[i] = channels[i] != nullptr ? channels[i] + offset : nullptr;

    const auto* const* const samples = buffer.getArrayOfReadPointers();
    router.process (
        { { samples, static_cast<std::size_t> (AntinodeProcessor::maximumCeramics) },
          { samples + AntinodeProcessor::maximumCeramics, static_cast<std::size_t> (OutputRouting::monitors) },
          { partChannels.data(), partChannels.size() },
          count,
          processor.session().fullScaleVolts(),
          processor.parameters().arm().get() });
}
} // namespace antinode
