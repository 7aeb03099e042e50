#include "RawVst3.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace antinode::test
{
template <typename Sample>
void RawVst3::playBlock (Vst3Block& block, Eigen::MatrixXd& played)
{
    Eigen::Matrix<Sample, Eigen::Dynamic, Eigen::Dynamic> samples (block.count, played.rows());
    samples.setConstant (Sample (7)); // So that what is not written is seen.
    std::vector<std::vector<Sample*>> pointers (2);
    std::vector<Vst::AudioBusBuffers> buses (2);
    Eigen::Index next = 0;

    for (std::size_t bus = 0; bus < buses.size(); ++bus)
    {
        for (int i = 0; i < channels (static_cast<int> (bus)); ++i)
            pointers[bus].push_back (active[bus] ? samples.col (next++).data() : nullptr);

        buses[bus].numChannels = static_cast<Steinberg::int32> (pointers[bus].size());
        buses[bus].channelBuffers32 = reinterpret_cast<float**> (pointers[bus].data()); // One union for both types.
    }

    Vst::ProcessData data;
    data.processMode = processing.isOffline ? Vst::kOffline : Vst::kRealtime;
    data.symbolicSampleSize = processing.isDouble ? Vst::kSample64 : Vst::kSample32;
    data.numSamples = block.count;
    data.numOutputs = static_cast<Steinberg::int32> (buses.size());
    data.outputs = buses.data();
    data.inputEvents = &block.events;
    data.inputParameterChanges = &block.changes;

    if (processor->process (data) != Steinberg::kResultTrue)
        throw std::runtime_error ("process() failed");

    played.middleCols (block.start, block.count) = samples.transpose().template cast<double>();
}

Eigen::MatrixXd RawVst3::play (int samples, int length, const std::function<void (Vst3Block&)>& prepareBlock)
{
    Eigen::MatrixXd played (channels (0) + (active[1] ? channels (1) : 0), samples);

    for (int done = 0; done < samples; done += length)
    {
        Vst3Block block;
        block.start = done;
        block.count = std::min (length, samples - done);
        prepareBlock (block);

        if (processing.isDouble)
            playBlock<double> (block, played);
        else
            playBlock<float> (block, played);
    }

    return played;
}

Eigen::MatrixXd RawVst3::play (int samples, int length, int noteAt, int note)
{
    return play (samples, length,
                 [&] (Vst3Block& block)
                 {
                     if (noteAt >= block.start && noteAt < block.start + block.count)
                         block.events.events.push_back (noteOn (noteAt - block.start, note));
                 });
}

Vst::Event noteOn (int offset, int note, float velocity)
{
    Vst::Event event {};
    event.sampleOffset = offset;
    event.type = Vst::Event::kNoteOnEvent;
    event.noteOn = { 0, static_cast<Steinberg::int16> (note), 0, velocity, 0, -1 };
    return event;
}
} // namespace antinode::test
