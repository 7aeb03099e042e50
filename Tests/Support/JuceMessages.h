#pragma once

#include <juce_core/juce_core.h>

// Of juce_events, for those who run no loop of its own; no header has it.
#if JUCE_MAJOR_VERSION < 8
namespace juce
#else
namespace juce::detail
#endif
{
bool dispatchNextMessageOnSystemQueue (bool returnIfNoPendingMessages);
}

namespace antinode::test
{
/** Answers the next message of the system, if one waits. [main thread]
    @return  whether one did */
inline bool answerNextMessage()
{
    using namespace juce;
#if JUCE_MAJOR_VERSION >= 8
    using namespace juce::detail;
#endif
    return dispatchNextMessageOnSystemQueue (true);
}
} // namespace antinode::test
