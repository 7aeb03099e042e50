#include "CommandLine.h"

#include <antinode_audio/Interruption.h>

#include <juce_events/juce_events.h>

int main (int argumentCount, char** arguments)
{
    // Fonts and pictures share objects of JUCE that are freed with it.
    const juce::ScopedJuceInitialiser_GUI juce;
    antinode::catchInterruptions();
    return antinode::runCommandLine (argumentCount, arguments);
}
