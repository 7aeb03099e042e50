#include "AudioCallback.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace antinode
{
void InputTap::write (const float* samples, int count)
{
    auto largest = 0.0F;
    std::int64_t beyond = 0;

    for (int n = 0; n < count; ++n)
    {
        const auto sample = std::isfinite (samples[n]) ? samples[n] : 0.0F;
        largest = std::max (largest, std::abs (sample));
        beyond += std::abs (sample) >= clipping ? 1 : 0;
        waiting.push (sample);
    }

    if (largest > peak.load (std::memory_order_relaxed))
        peak.store (largest, std::memory_order_relaxed);

    if (beyond > 0)
        clipped.fetch_add (beyond, std::memory_order_relaxed);
}

std::vector<float> InputTap::take()
{
    std::vector<float> samples (waiting.size());

    for (auto& sample : samples)
        sample = waiting.pop().value_or (0.0F);

    return samples;
}

namespace
{
constexpr int mostSamples = 1024;          // that the processor gets at once
constexpr std::size_t maximumNotes = 4096; // of one block that there is room for
constexpr int processorChannels = OutputRouting::maximumCeramics + OutputRouting::monitors;

/** The numbers of the channels that are open, in the order in which a device hands them over. @return how many */
int openNumbers (const juce::BigInteger& open, std::array<int, OutputRouting::maximumOutputs>& numbers)
{
    int count = 0;

    for (auto channel = open.findNextSetBit (0); channel >= 0 && channel < OutputRouting::maximumOutputs;
         channel = open.findNextSetBit (channel + 1))
        numbers[static_cast<std::size_t> (count++)] = channel;

    return count;
}
} // namespace

AudioCallback::AudioCallback (juce::AudioProcessor& processorToPlay, OutputRouter& routerToUse, MidiQueue& queueToRead,
                              PlayedLevels levelsToAsk)
    : processor (processorToPlay), router (routerToUse), queue (queueToRead), levels (std::move (levelsToAsk))
{
    setInputs ({});
    notes.ensureSize (MidiQueue::bytesNeeded (maximumNotes));
    partNotes.ensureSize (MidiQueue::bytesNeeded (maximumNotes));
}

void AudioCallback::setInputs (const FingerInputs& wanted)
{
    std::copy (wanted.inputs.begin(), wanted.inputs.end(), inputOfChannel.begin());
    inputOfChannel.back() = wanted.sensor;
}

void AudioCallback::playTake (std::shared_ptr<Take> take, std::uint64_t stops, int ceramics, double fullScaleVolts,
                              const std::array<int, 2>& inputs)
{
    takeCommands = stops;
    takeCeramics = std::clamp (ceramics, 0, OutputRouting::maximumCeramics);
    takeFullScale = fullScaleVolts;
    std::copy (inputs.begin(), inputs.end(), takeInputs.begin());
    recorder.begin (std::move (take));
}

void AudioCallback::audioDeviceAboutToStart (juce::AudioIODevice* opened)
{
    device = opened;
    prepare (device->getCurrentSampleRate(), device->getCurrentBufferSizeSamples(), device->getActiveOutputChannels(),
             device->getActiveInputChannels());
}

void AudioCallback::prepare (double sampleRate, int blockSize, const juce::BigInteger& openOutputs,
                             const juce::BigInteger& openInputs)
{
    firstInput = openInputs.findNextSetBit (0);
    openChannels = openNumbers (openOutputs, numbers);
    openInputChannels = openNumbers (openInputs, inputNumbers);
    longestPart = std::clamp (blockSize, 1, mostSamples);
    buffer.setSize (processorChannels, longestPart);
    marker.resize (static_cast<std::size_t> (longestPart));
    processor.setRateAndBufferSizeDetails (sampleRate, longestPart);
    processor.prepareToPlay (sampleRate, longestPart);
    router.prepare (sampleRate);
    recorder.cut (false);
    recorder.prepare (sampleRate);
    rate = sampleRate;
}

void AudioCallback::audioDeviceStopped()
{
    rate = 0;
    firstInput = -1;
    device = nullptr;
    recorder.cut (false);
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

    noteInputs (inputs, inputCount);
    channels.fill (nullptr);

    for (int i = 0; i < outputCount; ++i)
        if (i < openChannels)
            channels[static_cast<std::size_t> (numbers[static_cast<std::size_t> (i)])] = outputs[i];
        else if (outputs[i] != nullptr)
            std::fill_n (outputs[i], count, 0.0F);

    gatherNotes (count);

    for (int offset = 0; offset < count; offset += longestPart)
        playPart (offset, std::min (longestPart, count - offset));

    if (device != nullptr)
        lost = std::max (0, device->getXRunCount());

    played += count;
}

void AudioCallback::noteInputs (const float* const* inputs, int inputCount)
{
    heard.fill (nullptr);

    for (int i = 0; i < std::min (inputCount, openInputChannels); ++i)
        heard[static_cast<std::size_t> (inputNumbers[static_cast<std::size_t> (i)])] = inputs[i];
}

/** What fingers feel or the sensor hears, where the processor has inputs. */
void AudioCallback::fillInputs (int offset, int count)
{
    const auto channels = std::min (processor.getTotalNumInputChannels(), static_cast<int> (inputOfChannel.size()));

    for (int k = 0; k < channels; ++k)
    {
        const auto wanted = inputOfChannel[static_cast<std::size_t> (k)].load();
        const auto input = wanted == FingerInputs::firstOpen ? firstInput.load() : wanted;

        if (input < 0 || input >= OutputRouting::maximumOutputs)
            continue;

        if (const auto* const from = heard[static_cast<std::size_t> (input)]; from != nullptr)
            buffer.copyFrom (k, 0, from + offset, count);
    }
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

    // All its notes were asked for at once.
    if (queue.stops().commands() != scheduleCommands)
        schedule.end();

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
    fillInputs (offset, count);
    partNotes.clear();
    partNotes.addEvents (notes, offset, count, -offset);
    processor.processBlock (buffer, partNotes);
    const auto width = levels.writeMarker ? router.markerSamples() : 0;

    if (width > 0)
        levels.writeMarker (marker.data(), count, width);

    const auto stay = playTakePart (offset, count);
    const auto isMeasured = stay != OutputRouter::noStay;

    for (std::size_t i = 0; i < channels.size(); ++i)
        partChannels[i] = channels[i] != nullptr ? channels[i] + offset : nullptr;

    const auto* const* const samples = buffer.getArrayOfReadPointers();
    router.process ({ { samples, static_cast<std::size_t> (OutputRouting::maximumCeramics) },
                      { samples + OutputRouting::maximumCeramics, static_cast<std::size_t> (OutputRouting::monitors) },
                      { partChannels.data(), partChannels.size() },
                      count,
                      isMeasured ? takeFullScale.load() : levels.fullScaleVolts(),
                      levels.isArmed(),
                      width > 0 || isMeasured ? marker.data() : nullptr,
                      stay });
}

/** The next samples of a take, in place of what the processor plays. @return  the stay at it of the router, or none */
int AudioCallback::playTakePart (int offset, int count)
{
    if (! router.playsMeasurement())
    {
        recorder.cut (router.mayMeasure (levels.isArmed()));
        return OutputRouter::noStay;
    }

    const auto stay = router.stay();

    if (stay != takeStay && recorder.hasBegun())
        recorder.cut (true); // It was left and is there again, by another routing.

    if (queue.stops().commands() != takeCommands)
        recorder.stop();

    buffer.clear();
    std::fill_n (marker.begin(), count, 0.0F);
    std::array<float*, OutputRouting::maximumCeramics + 1> to {};
    const auto ceramics = takeCeramics.load();
    std::copy_n (buffer.getArrayOfWritePointers(), ceramics, to.begin());
    to[static_cast<std::size_t> (ceramics)] = marker.data();

    if (router.isLeaving() && ! recorder.hasBegun())
        return stay; // It begins in the next stay.

    takeStay = stay;
    std::array<const float*, 2> from {};

    for (std::size_t i = 0; i < from.size(); ++i)
        if (const auto input = takeInputs[i].load(); input >= 0 && input < OutputRouting::maximumOutputs)
            if (const auto* const samples = heard[static_cast<std::size_t> (input)]; samples != nullptr)
                from[i] = samples + offset;

    recorder.process (from.data(), static_cast<int> (from.size()), to.data(), ceramics + 1, count);
    return stay;
}
} // namespace antinode
