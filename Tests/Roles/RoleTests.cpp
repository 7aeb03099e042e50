#include "PlayedRole.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <initializer_list>
#include <thread>

// What holds for plug-ins of all roles, stated once.

using namespace antinode;
using namespace antinode::test;

#define ALL_ROLES AntinodeProcessor, TouchProcessor, PlateProcessor

namespace
{
/** Channels of the inputs, the main one first, and of the output. */
juce::AudioProcessor::BusesLayout layoutOf (std::initializer_list<int> inputs, int outputs)
{
    juce::AudioProcessor::BusesLayout layout;

    for (const auto channels : inputs)
        layout.inputBuses.add (juce::AudioChannelSet::discreteChannels (channels));

    layout.outputBuses.add (juce::AudioChannelSet::discreteChannels (outputs));
    return layout;
}
} // namespace

TEMPLATE_TEST_CASE ("Unprepared, or with fewer channels than were asked for, a plug-in is silent", "[role]", ALL_ROLES)
{
    const auto processor = makeRole<TestType>();
    CHECK (playedRole (*processor, 512).isZero (0));
    juce::AudioBuffer<float> tooFew (1, 64);
    tooFew.clear();
    tooFew.setSample (0, 3, 1);
    juce::MidiBuffer midi;
    processor->processBlock (tooFew, midi);
    CHECK (tooFew.getMagnitude (0, 64) == 0);
}

TEMPLATE_TEST_CASE ("Floats and doubles play alike, to single precision", "[role]", ALL_ROLES)
{
    const auto one = offlineRole<TestType>(), other = offlineRole<TestType>();
    const auto doubles = playedRole<double> (*one, 6000, 100), floats = playedRole<float> (*other, 6000, 100);
    CHECK (doubles.cwiseAbs().maxCoeff() > 1e-4);
    CHECK ((doubles - floats).cwiseAbs().maxCoeff() < 1e-6 * doubles.cwiseAbs().maxCoeff());
}

TEMPLATE_TEST_CASE ("With fewer channels than ceramics the others get 0 V, and that is said", "[role]", ALL_ROLES)
{
    const auto narrow = offlineRole<TestType> (64);
    CHECK (narrow->warning().isEmpty());
    auto layout = narrow->getBusesLayout();
    auto& buses = std::is_same_v<TestType, PlateProcessor> ? layout.inputBuses : layout.outputBuses;
    buses.getReference (0) = juce::AudioChannelSet::discreteChannels (3);
    REQUIRE (narrow->setBusesLayout (layout));
    prepareRole (*narrow);
    const auto ceramics = std::to_string (narrow->session().snapshot()->model->actuators());
    CHECK (narrow->warning()
           == "The device has " + juce::String (ceramics)
                  + " ceramics, but this bus has only 3 channels: ceramic 4 and above stay at 0 V.");
    CHECK (playedRole (*narrow, 6000).cwiseAbs().maxCoeff() > 1e-6);
}

TEST_CASE ("Layouts of as many channels as a role has are taken, others not", "[role]")
{
    const auto takes = [] (const DeviceProcessor& processor, std::initializer_list<int> inputs, int outputs)
    { return processor.isBusesLayoutSupported (layoutOf (inputs, outputs)); };
    const auto touch = makeRole<TouchProcessor> (32);
    CHECK (takes (*touch, { 1, 0 }, 1));
    CHECK (takes (*touch, { 8, 0 }, 64));
    CHECK (takes (*touch, { 2, 0 }, 2));
    CHECK_FALSE (takes (*touch, { 0, 0 }, 8));
    CHECK_FALSE (takes (*touch, { 9, 0 }, 8));
    CHECK_FALSE (takes (*touch, { 1, 0 }, 0));
    CHECK_FALSE (takes (*touch, { 8, 0 }, 65));
    const auto plate = makeRole<PlateProcessor> (32);
    CHECK (takes (*plate, { 1 }, 1));
    CHECK (takes (*plate, { 64 }, 8));
    CHECK (takes (*plate, { 2 }, 2));
    CHECK_FALSE (takes (*plate, { 0 }, 2));
    CHECK_FALSE (takes (*plate, { 2 }, 0));
    CHECK_FALSE (takes (*plate, { 65 }, 8));
    CHECK_FALSE (takes (*plate, { 8 }, 9));
}

TEMPLATE_TEST_CASE ("A device without ceramics leaves the present one playing, and says why", "[role]", ALL_ROLES)
{
    const auto processor = offlineRole<TestType>();
    auto json = loadDocument (LibraryKind::device, "beam");
    json["ceramics"] = nlohmann::json::array();
    loadDevice (*processor, json);
    processor->session().waitUntilSettled();
    CHECK (processor->warning() == "device 'beam': has no ceramics, so nothing can move it");
    CHECK (playedRole (*processor, 6000).cwiseAbs().maxCoeff() > 1e-4);
}

TEMPLATE_TEST_CASE ("A device that has to be armed comes disarmed, from a file and from a state, no other", "[role]",
                    AntinodeProcessor, TouchProcessor)
{
    const auto processor = offlineRole<TestType>(), restored = offlineRole<TestType>();
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["name"] = "another";
    loadDevice (*processor, json);
    CHECK (processor->parameters().arm().get());
    json["limits"]["requires_arming"] = true;
    loadDevice (*processor, json);
    CHECK_FALSE (processor->parameters().arm().get());
    prepareRole (*processor);
    CHECK (playedRole (*processor, 6000).topRows (8).rightCols (5400).isZero (0));
    processor->parameters().arm() = true;
    const auto kept = stateText (*processor);

    for (auto* const other : { processor.get(), restored.get() })
    {
        setStateText (*other, kept);
        CHECK_FALSE (other->parameters().arm().get());
    }
}

TEMPLATE_TEST_CASE ("Plug-ins end in the middle of anything", "[role]", ALL_ROLES)
{
    for (int i = 0; i < 12; ++i)
    {
        const auto processor = makeRole<TestType>();

        if constexpr (std::is_same_v<TestType, TouchProcessor>)
            processor->session().setComparing (i % 2 == 0);

        if (i % 3 != 0)
            processor->prepareToPlay (48000, 64);

        if (i % 4 == 0)
            loadDevice (*processor, loadDocument (LibraryKind::device, "beam"));

        playedRole (*processor, 64 * i);
        processor->parameters().all().front()->setValueNotifyingHost (static_cast<float> (i) / 12);
        std::this_thread::sleep_for (std::chrono::milliseconds (20 * i));
    }

    SUCCEED();
}
