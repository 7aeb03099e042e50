#include "VST3Extensions.h"

#include "ParameterTypes.h"

// The interfaces as Steinberg gives them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#include <pluginterfaces/vst/ivstaudioprocessor.h>
#include <pluginterfaces/vst/ivsteditcontroller.h>
#include <pluginterfaces/vst/ivstevents.h>
#include <pluginterfaces/vst/ivstmidicontrollers.h>
#include <pluginterfaces/vst/ivstparameterchanges.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

namespace antinode
{
namespace
{
namespace Vst = Steinberg::Vst;
using Steinberg::int32;
using Steinberg::tresult;
using Steinberg::uint32;

constexpr int32 usualBlock = 1024; // samples, where a host announces none

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor" // Interfaces of VST3 have none.

/** The events of a part of a block, those that stop before the notes of the same sample. */
class PartEvents final : public Vst::IEventList
{
public:
    /** @param from, to  samples of the block; events before all parts and behind them belong to the outermost */
    PartEvents (const Vst::ProcessData& block, Vst::IParamValueQueue* stopPoints, int32 from, int32 to)
        : notes (block.inputEvents), stops (stopPoints), offset (from), first (from > 0 ? from : Steinberg::kMinInt32),
          last (to < block.numSamples ? to : Steinberg::kMaxInt32)
    {
    }

    int32 PLUGIN_API getEventCount() override { return stopCount() + (notes != nullptr ? notes->getEventCount() : 0); }

    /** @return  kResultFalse for those of other parts, which the wrapper skips */
    tresult PLUGIN_API getEvent (int32 index, Vst::Event& event) override
    {
        const auto isFound =
            index < stopCount()
                ? findStop (index, event)
                : notes != nullptr && notes->getEvent (index - stopCount(), event) == Steinberg::kResultOk;

        if (! isFound || event.sampleOffset < first || event.sampleOffset >= last)
            return Steinberg::kResultFalse;

        event.sampleOffset -= offset;
        return Steinberg::kResultOk;
    }

    tresult PLUGIN_API addEvent (Vst::Event&) override { return Steinberg::kNotImplemented; }
    tresult PLUGIN_API queryInterface (const Steinberg::TUID, void** object) override
    {
        *object = nullptr;
        return Steinberg::kNoInterface;
    }
    uint32 PLUGIN_API addRef() override { return 1; }
    uint32 PLUGIN_API release() override { return 1; }

private:
    int32 stopCount() const { return stops != nullptr ? stops->getPointCount() : 0; }

    /** A point as the controller that it was, whatever its value. */
    bool findStop (int32 index, Vst::Event& event) const
    {
        Vst::ParamValue value = 0;
        event = {};
        event.type = Vst::Event::kLegacyMIDICCOutEvent;
        event.midiCCOut.controlNumber = Vst::kCtrlAllNotesOff;
        return stops->getPoint (index, event.sampleOffset, value) == Steinberg::kResultOk;
    }

    Vst::IEventList* notes;
    Vst::IParamValueQueue* stops;
    int32 offset, first, last;
};

/** Stands at 1 whatever a host sets, so that each stop is a change, whose controllers are all 0. */
class StopParameter final : public SwitchParameter
{
public:
    explicit StopParameter (const juce::String& identifier)
        : SwitchParameter (juce::ParameterID (identifier, 1), "Stop", true, flagTexts ("play", "stop"), false)
    {
    }

private:
    void setValue (float) override {}
};

/** Sends the controllers that stop to a parameter. */
class StopMapping final : public Vst::IMidiMapping
{
public:
    explicit StopMapping (Vst::ParamID parameter) : stop (parameter) {}

    tresult PLUGIN_API getMidiControllerAssignment (int32 bus, Steinberg::int16, Vst::CtrlNumber controller,
                                                    Vst::ParamID& parameter) override
    {
        if (bus != 0 || (controller != Vst::kCtrlAllSoundsOff && controller != Vst::kCtrlAllNotesOff))
            return Steinberg::kResultFalse;

        parameter = stop;
        return Steinberg::kResultTrue;
    }

    tresult PLUGIN_API queryInterface (const Steinberg::TUID identifier, void** object) override
    {
        const auto isOurs = Steinberg::FUnknownPrivate::iidEqual (identifier, Vst::IMidiMapping::iid)
                            || Steinberg::FUnknownPrivate::iidEqual (identifier, Steinberg::FUnknown::iid);
        *object = isOurs ? static_cast<Vst::IMidiMapping*> (this) : nullptr;

        if (isOurs)
            addRef();

        return isOurs ? Steinberg::kResultOk : Steinberg::kNoInterface;
    }
    uint32 PLUGIN_API addRef() override { return ++users; }
    uint32 PLUGIN_API release() override
    {
        const auto left = --users;

        if (left == 0)
            delete this;

        return left;
    }

private:
    Vst::ParamID stop;
    std::atomic<uint32> users { 1 };
};
} // namespace

/** Stands before the wrapper's IAudioProcessor, and belongs to the same object. */
class VST3Extensions::Parts final : public Vst::IAudioProcessor
{
public:
    explicit Parts (juce::AudioProcessor& processorToAsk) : processor (processorToAsk) {}

    juce::RangedAudioParameter& addStop()
    {
        constexpr Vst::ParamID positive = 0x7fffffff;
        const juce::String identifier ("stop");
        auto* const parameter = new StopParameter (identifier);
        processor.addParameter (parameter);
        stopIdentifier = static_cast<Vst::ParamID> (identifier.hashCode()) & positive;
        return *parameter;
    }

    /** As the wrapper numbers it; none: nothing is to be stopped. */
    std::optional<Vst::ParamID> stop() const { return stopIdentifier; }

    /** The wrapper's, which is our play head too; none: we are in no VST3. */
    Vst::IAudioProcessor* find() { return wrapped = dynamic_cast<Vst::IAudioProcessor*> (processor.getPlayHead()); }

    tresult PLUGIN_API queryInterface (const Steinberg::TUID identifier, void** object) override
    {
        return wrapped->queryInterface (identifier, object);
    }
    uint32 PLUGIN_API addRef() override { return wrapped->addRef(); }
    uint32 PLUGIN_API release() override { return wrapped->release(); }

    tresult PLUGIN_API setBusArrangements (Vst::SpeakerArrangement* inputs, int32 inputCount,
                                           Vst::SpeakerArrangement* outputs, int32 outputCount) override
    {
        return wrapped->setBusArrangements (inputs, inputCount, outputs, outputCount);
    }
    tresult PLUGIN_API getBusArrangement (Vst::BusDirection direction, int32 index,
                                          Vst::SpeakerArrangement& arrangement) override
    {
        return wrapped->getBusArrangement (direction, index, arrangement);
    }
    tresult PLUGIN_API canProcessSampleSize (int32 size) override { return wrapped->canProcessSampleSize (size); }
    uint32 PLUGIN_API getLatencySamples() override { return wrapped->getLatencySamples(); }
    uint32 PLUGIN_API getTailSamples() override { return wrapped->getTailSamples(); }
    tresult PLUGIN_API setProcessing (Steinberg::TBool state) override { return wrapped->setProcessing (state); }

    tresult PLUGIN_API setupProcessing (Vst::ProcessSetup& wanted) override
    {
        auto setup = wanted;
        setup.maxSamplesPerBlock = setup.maxSamplesPerBlock > 0 ? setup.maxSamplesPerBlock : usualBlock;
        return wrapped->setupProcessing (setup);
    }

    tresult PLUGIN_API process (Vst::ProcessData& block) override
    {
        const auto longest = processor.getBlockSize(); // For which the wrapper has buffers.
        auto* const stops = findStops (block.inputParameterChanges);

        if (block.numSamples <= longest && stops == nullptr)
            return wrapped->process (block);

        if (longest < 1 || ! PartBuses::hasRoomFor (block.inputs, block.numInputs)
            || ! PartBuses::hasRoomFor (block.outputs, block.numOutputs))
            return Steinberg::kInvalidArgument;

        tresult result = Steinberg::kResultTrue;
        int32 offset = 0;

        do
        {
            result = playPart (block, stops, offset, std::min (longest, block.numSamples - offset));
            offset += longest;
        } while (offset < block.numSamples && result == Steinberg::kResultTrue);

        return result;
    }

private:
    /** The buses of one direction from a sample of a block on. */
    class PartBuses
    {
    public:
        static constexpr int mostBuses = 8, mostChannels = 512;

        /** @return  whether there is room for all */
        static bool hasRoomFor (const Vst::AudioBusBuffers* buses, int32 count)
        {
            int channels = 0;

            for (int32 i = 0; i < count; ++i)
                channels += buses[i].numChannels;

            return count <= mostBuses && channels <= mostChannels;
        }

        template <typename Sample>
        Vst::AudioBusBuffers* from (int32 offset, const Vst::AudioBusBuffers* whole, int32 count)
        {
            auto* next = channels.data();

            for (int32 i = 0; i < count; ++i)
            {
                auto& bus = buses[static_cast<std::size_t> (i)];
                bus = whole[i];

                if (bus.channelBuffers32 == nullptr) // One union for both types.
                    continue;

                auto** const given = reinterpret_cast<Sample**> (bus.channelBuffers32);
                bus.channelBuffers32 = reinterpret_cast<Steinberg::Vst::Sample32**> (next);
                next = std::transform (given, given + bus.numChannels, next,
                                       [offset] (Sample* channel) -> void*
                                       { return channel != nullptr ? channel + offset : nullptr; });
            }

            return count > 0 ? buses.data() : nullptr;
        }

    private:
        std::array<Vst::AudioBusBuffers, mostBuses> buses {};
        std::array<void*, mostChannels> channels {};
    };

    /** The wrapper gives a parameter its last value at the start of a block: so the first part brings them, and the
       last takes what the host is told. */
    tresult playPart (Vst::ProcessData& block, Vst::IParamValueQueue* stops, int32 offset, int32 count)
    {
        const auto end = offset + count;
        PartEvents events (block, stops, offset, end);
        auto part = block;
        part.numSamples = count;
        part.inputs = busesFrom (inputs, offset, block.inputs, block.numInputs);
        part.outputs = busesFrom (outputs, offset, block.outputs, block.numOutputs);
        part.inputEvents = &events;
        part.inputParameterChanges = offset == 0 ? block.inputParameterChanges : nullptr;
        part.outputParameterChanges = end == block.numSamples ? block.outputParameterChanges : nullptr;
        const auto result = wrapped->process (part);

        for (int32 i = 0; i < block.numOutputs; ++i)
            block.outputs[i].silenceFlags &= part.outputs[i].silenceFlags;

        return result;
    }

    Vst::IParamValueQueue* findStops (Vst::IParameterChanges* changes) const
    {
        if (stopIdentifier && changes != nullptr)
            for (int32 i = 0; i < changes->getParameterCount(); ++i)
                if (auto* const queue = changes->getParameterData (i);
                    queue != nullptr && queue->getParameterId() == *stopIdentifier)
                    return queue;

        return nullptr;
    }

    Vst::AudioBusBuffers* busesFrom (PartBuses& buses, int32 offset, const Vst::AudioBusBuffers* whole,
                                     int32 count) const
    {
        return processor.isUsingDoublePrecision() ? buses.from<double> (offset, whole, count)
                                                  : buses.from<float> (offset, whole, count);
    }

    juce::AudioProcessor& processor;
    Vst::IAudioProcessor* wrapped = nullptr;
    std::optional<Vst::ParamID> stopIdentifier;
    PartBuses inputs, outputs; ///< Of the audio thread.
};

#pragma GCC diagnostic pop

VST3Extensions::VST3Extensions (juce::AudioProcessor& processor) : parts (std::make_unique<Parts> (processor)) {}

VST3Extensions::~VST3Extensions() = default;

juce::RangedAudioParameter& VST3Extensions::addStop()
{
    return parts->addStop();
}

int32_t VST3Extensions::queryIEditController (const Steinberg::TUID identifier, void** object)
{
    *object = nullptr;

    if (! Steinberg::FUnknownPrivate::iidEqual (identifier, Vst::IMidiMapping::iid) || ! parts->stop())
        return Steinberg::kNoInterface;

    *object = static_cast<Vst::IMidiMapping*> (new StopMapping (*parts->stop()));
    return Steinberg::kResultOk;
}

/** Hosts of JUCE ask the component too, and the controller before it knows its processor. */
int32_t VST3Extensions::queryIAudioProcessor (const Steinberg::TUID identifier, void** object)
{
    if (queryIEditController (identifier, object) == Steinberg::kResultOk)
        return Steinberg::kResultOk;

    if (! Steinberg::FUnknownPrivate::iidEqual (identifier, Vst::IAudioProcessor::iid) || parts->find() == nullptr)
        return Steinberg::kNoInterface;

    parts->addRef();
    *object = static_cast<Vst::IAudioProcessor*> (parts.get());
    return Steinberg::kResultOk;
}
} // namespace antinode
