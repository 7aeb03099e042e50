#include "PlayAndRecord.h"

#include <algorithm>

namespace antinode
{
void PlayAndRecord::begin (Take& take)
{
    stops = false;
    current = &take;
}

void PlayAndRecord::audioDeviceAboutToStart (juce::AudioIODevice* device)
{
    constexpr double rampTime = 0.02; // s
    rampSamples = static_cast<std::int64_t> (rampTime * device->getCurrentSampleRate());
}

void PlayAndRecord::audioDeviceIOCallbackWithContext (const float* const* inputs, int inputCount, float* const* outputs,
                                                      int outputCount, int count,
                                                      const juce::AudioIODeviceCallbackContext&)
{
    for (int channel = 0; channel < outputCount; ++channel)
        std::fill_n (outputs[channel], count, 0.0F);

    if (auto* const take = current.load())
        run (*take, inputs, inputCount, outputs, outputCount, count);

    ++called;
}

void PlayAndRecord::run (Take& take, const float* const* inputs, int inputCount, float* const* outputs, int outputCount,
                         int count)
{
    const Eigen::Index first = take.samples;
    const auto samples = std::min<Eigen::Index> (count, take.played.rows() - first);

    for (Eigen::Index channel = 0; channel < std::min<Eigen::Index> (outputCount, take.played.cols()); ++channel)
        std::copy_n (take.played.col (channel).data() + first, samples, outputs[channel]);

    for (Eigen::Index channel = 0; channel < std::min<Eigen::Index> (inputCount, take.recorded.cols()); ++channel)
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
    {
        current = nullptr;
        take.isDone = true;
    }
}
} // namespace antinode
