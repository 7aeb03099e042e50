#include "Support/JuceMessages.h"

#include <Processor/AntinodeProcessor.h>

#include <catch2/catch.hpp>

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

/** Answers all messages that wait now: they come in the order in which they were sent. */
void answerMessages()
{
    bool isLastAnswered = false;
    juce::MessageManager::callAsync ([&isLastAnswered] { isLastAnswered = true; });

    while (! isLastAnswered)
        if (! test::answerNextMessage())
            std::this_thread::yield();
}
} // namespace

TEST_CASE ("A model that is ready before a host has prepared the plug-in is told of once it has", "[plugin]")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_VST3); // It sends a message itself.
    TextListener host;
    processor.addListener (&host);
    processor.session().waitUntilSettled();
    answerMessages();
    REQUIRE (processor.session().snapshot()->model != nullptr);
    CHECK (host.told == 0);

    processor.prepareToPlay (48000, 512);
    answerMessages();
    CHECK (host.told == 1);

    processor.prepareToPlay (48000, 512);
    answerMessages();
    CHECK (host.told == 1); // It knows them.
    processor.removeListener (&host);
}
