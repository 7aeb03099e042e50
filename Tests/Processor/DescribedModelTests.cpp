#include "Support/JuceMessages.h"

#include <Processor/AntinodeProcessor.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

using namespace antinode;

namespace
{
/** Counts how often a host is told that texts of parameters have changed. */
struct TextListener : juce::AudioProcessorListener
{
    void audioProcessorChanged (juce::AudioProcessor*, const ChangeDetails& details) override
    {
        told += details.parameterInfoChanged ? 1 : 0;
    }
    void audioProcessorParameterChanged (juce::AudioProcessor*, int, float) override {}

    int told = 0;
};

void answerMessagesFor (std::chrono::milliseconds time)
{
    for (const auto end = std::chrono::steady_clock::now() + time; std::chrono::steady_clock::now() < end;)
        if (! test::answerNextMessage())
            std::this_thread::sleep_for (std::chrono::milliseconds (1));
}
} // namespace

TEST_CASE ("A model that is ready before a host has prepared the plug-in is told of once it has", "[plugin]")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_VST3);
    TextListener host;
    processor.addListener (&host);
    processor.session().waitUntilSettled();
    answerMessagesFor (std::chrono::milliseconds (50));
    REQUIRE (processor.session().snapshot()->model != nullptr);
    CHECK (host.told == 0);

    processor.prepareToPlay (48000, 512);
    answerMessagesFor (std::chrono::milliseconds (50));
    CHECK (host.told == 1);

    processor.prepareToPlay (48000, 512);
    answerMessagesFor (std::chrono::milliseconds (50));
    CHECK (host.told == 1); // It knows them.
    processor.removeListener (&host);
}
