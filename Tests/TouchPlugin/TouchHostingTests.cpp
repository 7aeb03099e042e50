// What hosts do with Antinode Touch: layouts, latency, rates, states, devices, its end.

#include "JudgedTouch.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = judgedRate;
constexpr int ceramics = 12, length = 14400;

juce::MemoryBlock stateOf (TouchProcessor& processor)
{
    juce::MemoryBlock state;
    processor.getStateInformation (state);
    return state;
}
} // namespace

TEST_CASE ("A finger without an input is silent", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    REQUIRE (processor->setBusesLayout (touchLayout (2, ceramics)));
    parameters["finger3_state"] = 2;
    processor->parameters().setValues (parameters);
    processor->prepareToPlay (rate, 256);
    const auto inputs = withRest (fingerTones (2, length, rate));
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 256), inputs);
    REQUIRE (scores.fingers.size() == 3);
    CHECK (scores.normalisedError (1) < 1e-4);
    CHECK (scores.suppression (2) < -40);
}

TEST_CASE ("Layouts of 1 to 8 fingers and 1 to 64 ceramics are taken, others not", "[touch-plugin]")
{
    TouchProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (processor.isBusesLayoutSupported (touchLayout (1, 1)));
    CHECK (processor.isBusesLayoutSupported (touchLayout (8, 64)));
    CHECK (processor.isBusesLayoutSupported (touchLayout (2, 2)));
    CHECK_FALSE (processor.isBusesLayoutSupported (touchLayout (0, 8)));
    CHECK_FALSE (processor.isBusesLayoutSupported (touchLayout (9, 8)));
    CHECK_FALSE (processor.isBusesLayoutSupported (touchLayout (1, 0)));
    CHECK_FALSE (processor.isBusesLayoutSupported (touchLayout (8, 65)));
}

TEST_CASE ("Another latency is reported, and its filters give the same voltages as if they had been first",
           "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto changed = offlineTouch (ceramics, rate, 256, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    voltagesOf (*changed, inputs, 256);
    parameters["latency"] = 1;
    changed->parameters().setValues (parameters);
    changed->session().waitUntilSettled();
    const auto other = offlineTouch (ceramics, rate, 256, parameters);
    changed->prepareToPlay (rate, 256);
    CHECK (changed->getLatencySamples() == 480);
    CHECK (other->getLatencySamples() == 480);
    voltagesOf (*changed, Eigen::MatrixXd::Zero (2, length), 256);
    voltagesOf (*other, Eigen::MatrixXd::Zero (2, length), 256);
    CHECK ((voltagesOf (*changed, inputs, 256) - voltagesOf (*other, inputs, 256)).isZero (0));
}

TEST_CASE ("Every rate from 44.1 to 192 kHz has its latency within a sample of the filters, lower ones are refused",
           "[touch-plugin]")
{
    for (const auto hertz : { 44100.0, 88200.0, 192000.0 })
    {
        const auto processor = offlineTouch (ceramics, hertz, 256);
        CHECK (processor->getLatencySamples() / hertz == Approx (0.02).margin (1.0 / 4000));
        CHECK (voltagesOf (*processor, fingerTones (2, 20000, hertz), 256).cwiseAbs().maxCoeff() > 1e-4);
    }

    const auto slow = offlineTouch (ceramics, 2000, 256);
    CHECK (slow->warning().contains ("sample rate"));
    CHECK (voltagesOf (*slow, fingerTones (2, 2000, 2000), 256).isZero (0));
    slow->prepareToPlay (rate, 256);
    slow->session().waitUntilSettled();
    CHECK (slow->warning().isEmpty());
    CHECK (voltagesOf (*slow, fingerTones (2, length, rate), 256).cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("A device that has to be armed comes disarmed, from a file and from a state", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["limits"]["requires_arming"] = true;
    const auto processor = offlineTouch (ceramics, rate, 256);
    CHECK (processor->parameters().arm().get());
    processor->load (touchDeviceFrom (json));
    CHECK_FALSE (processor->parameters().arm().get());
    processor->session().waitUntilSettled();
    CHECK (voltagesOf (*processor, fingerTones (2, length, rate), 256).rightCols (length - 600).isZero (0));
    processor->parameters().arm() = true;
    const auto state = stateOf (*processor);
    const auto restored = offlineTouch (ceramics, rate, 256);
    restored->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    CHECK_FALSE (restored->parameters().arm().get());
}

TEST_CASE ("A state gives the same voltages back", "[touch-plugin]")
{
    auto parameters = threeFingers();
    parameters["latency"] = 2;
    const auto first = offlineTouch (ceramics, rate, 256, parameters);
    const auto second = offlineTouch (ceramics, rate, 256, {});
    const auto state = stateOf (*first);
    second->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    CHECK (stateOf (*second) == state);
    second->session().waitUntilSettled();
    first->prepareToPlay (rate, 256);
    second->prepareToPlay (rate, 256);
    const auto silence = Eigen::MatrixXd::Zero (8, 4800);
    voltagesOf (*first, silence, 256);
    voltagesOf (*second, silence, 256);
    const auto inputs = fingerTones (8, length, rate);
    CHECK ((voltagesOf (*second, inputs, 256) - voltagesOf (*first, inputs, 256)).isZero (0));
}

TEST_CASE ("A state of Antinode Touch that cannot be read changes nothing and is one sentence", "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 64);
    const auto before = stateOf (*processor);

    for (const auto& text :
         { std::string(), std::string ("no state"), std::string (1000, '\0'),
           std::string (R"({"schema":"antinode.plate/1"})"), std::string (R"({"schema":"antinode.touch/2"})"),
           std::string (R"({"schema":"antinode.touch/1","device":3,"parameters":{}})"),
           before.toString().toStdString().substr (0, 500) })
    {
        CAPTURE (text);
        processor->setStateInformation (text.data(), static_cast<int> (text.size()));
        CHECK (processor->warning().startsWith ("The saved state could not be read; nothing was changed: "));
        CHECK_FALSE (processor->warning().containsChar ('\n'));
        CHECK (stateOf (*processor) == before);
    }
}

TEST_CASE ("A device that no filters can be designed for leaves the present one playing, and says why",
           "[touch-plugin]")
{
    const auto processor = offlineTouch (ceramics, rate, 64);
    auto json = loadDocument (LibraryKind::device, "beam");
    json["ceramics"] = nlohmann::json::array();
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    CHECK (processor->warning() == "device 'beam': has no ceramics, so nothing can move it");
    CHECK (voltagesOf (*processor, fingerTones (2, length, rate), 64).cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("More fingers than ceramics are refused in a sentence", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["ceramics"].erase (json["ceramics"].begin() + 2, json["ceramics"].end());
    const auto processor = offlineTouch (2, rate, 64);
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    CHECK (processor->warning().startsWith ("touch 3 points; allowed: at most 2"));
}

TEST_CASE ("Touch plug-ins end in the middle of anything", "[touch-plugin]")
{
    for (int i = 0; i < 12; ++i)
    {
        TouchProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
        processor.session().setComparing (i % 2 == 0);

        if (i % 3 != 0)
            processor.prepareToPlay (rate, 64);

        if (i % 4 == 0)
            processor.load (touchDevice ("beam"));

        voltagesOf (processor, fingerTones (8, 64 * i, rate), 64);
        processor.parameters().finger (0).x->setValueNotifyingHost (static_cast<float> (i) / 12);
        std::this_thread::sleep_for (std::chrono::milliseconds (20 * i));
    }

    SUCCEED();
}
