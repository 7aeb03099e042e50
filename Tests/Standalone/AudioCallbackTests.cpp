#include <Processor/AntinodeProcessor.h>
#include <Standalone/AudioCallback.h>

#include "RouterRig.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
PlayedLevels levelsOf (AntinodeProcessor& processor)
{
    return { [&processor] { return processor.session().fullScaleVolts(); },
             [&processor] { return processor.parameters().arm().get(); } };
}

/** Keeps what comes in by the first channel. */
struct ListeningProcessor : AntinodeProcessor
{
    using AntinodeProcessor::AntinodeProcessor;
    using AntinodeProcessor::processBlock;

    void processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override
    {
        const auto* const samples = buffer.getReadPointer (0);
        heard.insert (heard.end(), samples, samples + buffer.getNumSamples());
        isBeyondPrepared = isBeyondPrepared || buffer.getNumSamples() > getBlockSize();
        AntinodeProcessor::processBlock (buffer, midi);
    }

    std::vector<float> heard;
    bool isBeyondPrepared = false;
};

/** The program's audio without a device. */
struct CallbackRig
{
    explicit CallbackRig (std::vector<TimedNote> notes = { { 0,
                                                             juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)) } },
                          const std::vector<int>& open = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 })
    {
        juce::BigInteger channels;

        for (const auto channel : open)
            channels.setBit (channel);

        callback.setSchedule (EventSchedule (std::move (notes)));
        callback.prepare (48000, 256, channels, {});
        processor.session().waitUntilSettled();
        processor.parameters().arm().setValueNotifyingHost (1);
        callback.startSchedule();
    }

    Channels play (int outputs, int count, const std::vector<int>& blocks)
    {
        auto played = constant (outputs, count, 7);
        std::size_t next = 0;

        for (int offset = 0, part = 0; offset < count; offset += part)
        {
            part = std::min (blocks[next++ % blocks.size()], count - offset);
            std::vector<float*> channels;

            for (auto& channel : played)
                channels.push_back (channel.data() + offset);

            callback.audioDeviceIOCallbackWithContext (nullptr, 0, channels.data(), outputs, part, {});
        }

        return played;
    }

    AntinodeProcessor processor { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    OutputRouter router;
    MidiQueue queue { processor.session().stops() };
    AudioCallback callback { processor, router, queue, levelsOf (processor) };
};

bool isSilent (const std::vector<float>& samples)
{
    return std::all_of (samples.begin(), samples.end(), [] (float sample) { return sample == 0; });
}
} // namespace

TEST_CASE ("a device gets the same samples whatever its blocks, also longer and shorter ones than it said")
{
    const auto whole = CallbackRig().play (10, 6000, { 256 });
    CHECK_FALSE (isSilent (whole[0]));
    CHECK_FALSE (isSilent (whole[7]));
    CHECK (isSilent (whole[8]));
    CHECK (CallbackRig().play (10, 6000, { 6000 }) == whole);
    CHECK (CallbackRig().play (10, 6000, { 1, 3000, 17, 0, 255 }) == whole);
}

TEST_CASE ("a device with fewer channels than ceramics gets the first ones")
{
    const auto whole = CallbackRig().play (10, 3000, { 256 });

    for (const auto outputs : { 0, 1, 3 })
    {
        const auto few = CallbackRig().play (outputs, 3000, { 256 });
        CHECK (few == Channels (whole.begin(), whole.begin() + outputs));
    }
}

TEST_CASE ("channels that are open keep their numbers, and those beyond are silent")
{
    const auto whole = CallbackRig().play (10, 3000, { 256 });
    const auto some =
        CallbackRig ({ { 0, juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)) } }, { 1, 6 }).play (3, 3000, { 256 });
    CHECK (some[0] == whole[1]);
    CHECK (some[1] == whole[6]);
    CHECK (isSilent (some[2]));
}

TEST_CASE ("a note of the schedule begins on its sample")
{
    constexpr int start = 2 * 256 + 100;
    const auto at = [] (double seconds)
    {
        CallbackRig rig ({ { 0.1 + seconds, juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)) } });
        return rig.play (8, 9000, { 256 });
    };
    const auto early = at (0), late = at (start / 48000.0);

    for (std::size_t k = 0; k < early.size(); ++k)
    {
        CHECK (isSilent ({ early[k].begin(), early[k].begin() + 4800 }));
        CHECK (std::equal (early[k].begin() + 4800, early[k].end() - start, late[k].begin() + 4800 + start));
    }
}

TEST_CASE ("a disarmed program gives 0 V")
{
    CallbackRig rig;
    rig.processor.parameters().arm().setValueNotifyingHost (0);
    rig.play (8, 240, { 240 }); // the ramp

    for (const auto& channel : rig.play (8, 4000, { 256 }))
        CHECK (isSilent (channel));
}

TEST_CASE ("a note from an input plays")
{
    CallbackRig rig { {} };
    CHECK (isSilent (rig.play (8, 1000, { 256 })[0]));
    rig.queue.push (juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)), juce::Time::getMillisecondCounterHiRes());
    CHECK_FALSE (isSilent (rig.play (8, 3000, { 256 })[0]));
}

TEST_CASE ("what an output cannot give limits the foci, so that no sample is clamped")
{
    AntinodeProcessor processor { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    OutputRouter router;
    MidiQueue queue { processor.session().stops() };
    AudioCallback callback { processor, router, queue, levelsOf (processor) };
    auto device = nlohmann::json::parse (processor.device()->text);
    device["limits"] = { { "voltage_V", 10 }, { "full_scale_V", 3 } };
    auto focus = nlohmann::json::parse (processor.focus()->text);
    focus["allocation"] = { { "method", "least_voltage" } };
    focus["targets"][0]["peak_velocity_mm_s"] = 20;
    processor.load (std::make_shared<const DeviceDocument> (readDeviceDocument (device, "device")),
                    std::make_shared<const FocusDocument> (readFocusDocument (focus, "focus")));

    processor.parameters().find ("notes")->setValueNotifyingHost (1);

    auto routing = straightRouting();
    routing.chains[0].voltsPerFullScale = 1.7;
    routing.chains[1] = { 600, -1 };
    processor.session().setAmplifiers (amplifierVoltages (routing));
    router.setRouting (routing, {});
    juce::BigInteger open;
    open.setRange (0, 8, true);
    callback.setSchedule (EventSchedule ({ { 0, juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)) },
                                           { 0.002, juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)) } }));
    callback.prepare (48000, 256, open, {});
    processor.session().waitUntilSettled();

    // This method takes a second for a focus, so there is only one.
    while (! processor.session().progress().isDone())
        std::this_thread::sleep_for (std::chrono::milliseconds (10));

    const auto model = processor.session().snapshot()->model;
    CHECK (voltageLimits (*model).head (3) == Eigen::Vector3d (1.7, 10, 3));
    CHECK (processor.session().progress().liveError.empty());

    processor.parameters().arm().setValueNotifyingHost (1);
    callback.startSchedule();
    auto played = constant (8, 6000, 7);
    std::vector<float*> channels;

    for (auto& channel : played)
        channels.push_back (channel.data());

    callback.audioDeviceIOCallbackWithContext (nullptr, 0, channels.data(), 8, 6000, {});
    CHECK_FALSE (isSilent (played[0]));

    for (int output = 0; output < 8; ++output)
        CHECK (router.meters().clampedSamples (output) == 0);
}

TEST_CASE ("the first open input goes to its tap, whatever the outputs do")
{
    CallbackRig rig;
    const std::vector<float> heard { 0.25F, -0.5F, 0.125F, 1.0F }, other (4, 0.75F);
    std::vector<float> played (4, 7);
    const std::array<const float*, 2> inputs { heard.data(), other.data() };
    const std::array<float*, 1> outputs { played.data() };
    rig.callback.audioDeviceIOCallbackWithContext (inputs.data(), 2, outputs.data(), 1, 4, {});
    CHECK (rig.callback.input().take() == heard);
    CHECK (rig.callback.input().clippedSamples() == 1);
    rig.callback.audioDeviceIOCallbackWithContext (nullptr, 0, outputs.data(), 1, 4, {});
    CHECK (rig.callback.input().take().empty());
}

TEST_CASE ("the first open input is what the sensor hears, whatever the blocks, and ceramics are none of it")
{
    ListeningProcessor processor { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    OutputRouter router;
    MidiQueue queue { processor.session().stops() };
    AudioCallback callback { processor, router, queue, levelsOf (processor) };
    juce::BigInteger outputs, inputs;
    outputs.setRange (0, 8, true);
    inputs.setBit (5);
    inputs.setBit (2);
    callback.setInputs (sensorAlone());
    callback.prepare (48000, 256, outputs, inputs);
    std::vector<float> heard (3000), other (heard.size(), 0.75F);

    for (std::size_t n = 0; n < heard.size(); ++n)
        heard[n] = static_cast<float> (n % 97) / 97;

    auto played = constant (8, 3000, 7);
    std::vector<float*> channels;

    for (auto& channel : played)
        channels.push_back (channel.data());

    const std::array<const float*, 2> sources { heard.data(), other.data() };
    callback.audioDeviceIOCallbackWithContext (sources.data(), 2, channels.data(), 8, 3000, {});
    CHECK (processor.heard == heard);
    CHECK_FALSE (processor.isBeyondPrepared);
    CHECK (std::all_of (played.begin(), played.end(), isSilent));

    processor.heard.clear();
    callback.prepare (48000, 256, outputs, {});
    callback.audioDeviceIOCallbackWithContext (nullptr, 0, channels.data(), 8, 3000, {});
    CHECK (isSilent (processor.heard));
}
