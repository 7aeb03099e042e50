#include "CommandLine.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/System.h>

#include <juce_events/juce_events.h>

int main (int argumentCount, char** arguments)
{
    antinode::guardStandardStreams();
    antinode::keepFreedMemory();
    // Fonts and pictures share objects of JUCE that are freed with it.
    const juce::ScopedJuceInitialiser_GUI juce;
    antinode::catchInterruptions();
    auto texts = antinode::programArguments (argumentCount, arguments);
    const auto pointers = antinode::argumentPointers (texts);
    return antinode::runCommandLine (static_cast<int> (pointers.size()), pointers.data());
}
