#include "PlayAndRecord.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <utility>

namespace antinode
{
void PlayAndRecord::begin (std::shared_ptr<Take> take)
{
    if (current != nullptr)
        throw InputError ("audio device", "has stopped; choose it again, then repeat the measurement");

    stops = false;
    before = std::exchange (kept, std::move (take)); // It may just be told that it is done.
    current = kept.get();
}

void PlayAndRecord::prepare (double sampleRate)
{
    constexpr double rampTime = 0.02; // s
    rampSamples = static_cast<std::int64_t> (rampTime * sampleRate);
}

void PlayAndRecord::audioDeviceAboutToStart (juce::AudioIODevice* device)
{
    prepare (device->getCurrentSampleRate());
}

void PlayAndRecord::audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                                      int outputCount, int count,
                                                      const juce::AudioIODeviceCallbackContext&)
{
    for (int channel = 0; channel < outputCount; ++channel)
        std::fill_n (outputs[channel], count, 0.0F);

    process (inputs, inputCount, outputs, outputCount, count);
    ++called;
}

void PlayAndRecord::process (const float* const* inputs, int inputCount, float* const* outputs, int outputCount,
                             int count)
{
    if (auto* const take = current.load())
        run (*take, inputs, inputCount, outputs, outputCount, count);
}

void PlayAndRecord::cut (bool mayBegin)
{
    if (auto* const take = current.load(); take != nullptr && (! mayBegin || take->samples > 0))
        end (*take);
}

void PlayAndRecord::end (Take& take)
{
    current = nullptr;
    take.isDone = true;
}

void PlayAndRecord::run (Take& take, const float* const* inputs, int inputCount, float* const* outputs, int outputCount,
                         int count)
{
    const Eigen::Index first = take.samples;
    const auto samples = std::min<Eigen::Index> (count, take.played.rows() - first);

    for (Eigen::Index channel = 0; channel < std::min<Eigen::Index> (outputCount, take.played.cols()); ++channel)
    {
        std::fill_n (outputs[channel] + samples, count - samples, 0.0F);
        std::copy_n (take.played.col (channel).data() + first, samples, outputs[channel]);
    }

    for (Eigen::Index channel = 0; channel < std::min<Eigen::Index> (inputCount, take.recorded.cols()); ++channel)
        if (inputs[channel] != nullptr)
            std::copy_n (inputs[channel], samples, take.recorded.col (channel).data() + first);

    if (first == 0)
    {
        ramp.setTarget (1, 0);
        isStopping = false;
    }

    if (stops && ! isStopping)
    {
        ramp.setTarget (0, rampSamples);
        isStopping = true;
    }

    ramp.process (outputs, outputCount, count);
    take.samples = first + samples;

    if (take.samples == take.played.rows() || (isStopping && ! ramp.isMoving()))
        end (take);
}
} // namespace antinode
