#pragma once

#include "RawVst3.h"

#include <initializer_list>

namespace antinode::test
{
/** A block whose buses have so many channels, whatever was agreed. */
struct BareBlock
{
    BareBlock (int count, std::initializer_list<int> channelsOfBuses)
        : samples (Eigen::MatrixXf::Constant (std::max (1, count), 80, 7))
    {
        int next = 0;

        for (const auto channels : channelsOfBuses)
        {
            auto& bus = pointers.emplace_back();

            for (int i = 0; i < channels; ++i)
                bus.push_back (samples.col (next++ % 80).data());
        }

        for (auto& bus : pointers)
        {
            auto& buffers = buses.emplace_back();
            buffers.numChannels = static_cast<Steinberg::int32> (bus.size());
            buffers.channelBuffers32 = bus.data();
        }

        data.symbolicSampleSize = Vst::kSample32;
        data.numSamples = count;
        data.numOutputs = static_cast<Steinberg::int32> (buses.size());
        data.outputs = buses.empty() ? nullptr : buses.data();
        data.inputEvents = &events;
        data.inputParameterChanges = &changes;
    }

    Eigen::MatrixXf samples;
    std::vector<std::vector<float*>> pointers;
    std::vector<Vst::AudioBusBuffers> buses;
    EventList events;
    ParameterChanges changes;
    Vst::ProcessData data;
};
} // namespace antinode::test
