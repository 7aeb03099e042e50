#include "PlayedProcessor.h"

#include <catch2/catch.hpp>

#include <array>
#include <fstream>
#include <iterator>

using namespace antinode;

namespace
{
std::string readFixture (const std::string& name)
{
    std::ifstream file (std::string (ANTINODE_TEST_DATA) + "/States/" + name, std::ios::binary);
    REQUIRE (file);
    return { std::istreambuf_iterator<char> (file), {} };
}
} // namespace

// What version 0.1.0 kept: every later version has to load it.
TEST_CASE ("States of earlier versions load", "[plugin]")
{
    const auto text = readFixture ("state-1.json");
    const auto processor = test::offlineProcessor (8, 48000, 512);
    processor->setStateInformation (text.data(), static_cast<int> (text.size()));
    CHECK (processor->warning().isEmpty());
    CHECK (processor->device()->description.name == "beam");
    CHECK (processor->focus()->description.name == "aluminium-centre");
    CHECK (processor->parameters().settings().xPercent == 37.5F);
    CHECK (processor->parameters().settings().widthMillimetres == Approx (18.25));
    CHECK (processor->parameters().controls().notes.noteOff == NoteOffBehaviour::brake);
    CHECK_FALSE (processor->parameters().arm().get());
    CHECK (processor->mutes() == 0b10010);
}

TEST_CASE ("A state with a method that is no longer offered plays the nearest one, and says so until another is chosen",
           "[plugin]")
{
    const auto text = readFixture ("retired-method.json");
    const auto processor = test::offlineProcessor (8, 96000, 512);
    const auto retirement = [&]
    {
        std::string found;

        for (const auto& message : processor->messages())
            if (message.text.find ("no longer offered") != std::string::npos)
                found = message.text;

        return found;
    };
    CHECK (retirement().empty());
    processor->setStateInformation (text.data(), static_cast<int> (text.size()));
    processor->session().waitUntilSettled();
    CHECK (processor->warning().toStdString() == "");
    CHECK (
        retirement()
        == "The allocation method 'minimum_norm' is no longer offered: 'paper' is used, which gives the same voltages "
           "where they keep the limit; write 'paper'.");
    auto& method = *processor->parameters().find ("method");
    CHECK (method.getCurrentValueAsText() == "paper (was minimum norm)");
    CHECK (processor->session().snapshot()->focus.allocation.method == AllocationMethod::paper);

    // The host's own number stays what it was.
    juce::MemoryBlock kept;
    processor->getStateInformation (kept);
    CHECK (readState ({ static_cast<const char*> (kept.getData()), kept.getSize() }).parameters.at ("method") == 3);

    setValue (method, 0);
    processor->session().waitUntilSettled();
    CHECK (processor->session().snapshot()->focus.allocation.method == AllocationMethod::exact);
    CHECK (retirement().empty());
}

TEST_CASE ("Each number of the parameter of methods that a host has kept asks for what it did, or the nearest",
           "[plugin]")
{
    const auto processor = test::offlineProcessor (8, 48000, 512);
    auto& method = *processor->parameters().find ("method");
    const std::array<AllocationMethod, 8> wanted { AllocationMethod::exact,        AllocationMethod::paper,
                                                   AllocationMethod::paper,        AllocationMethod::paper,
                                                   AllocationMethod::exact,        AllocationMethod::leastVoltage,
                                                   AllocationMethod::leastVoltage, AllocationMethod::leastVoltage };

    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        CAPTURE (i);
        method.setValueNotifyingHost (static_cast<float> (i) / 7); // The share that a host automates.
        const auto settings = processor->parameters().settings();
        CHECK (settings.method == wanted[i]);
        CHECK ((settings.retired == nullptr) == (i < 2 || i == 7));
        processor->parameters().setFocus (settings);
        CHECK (parameterValue (method) == static_cast<double> (i));
    }
}
