#pragma once

#include <chrono>

namespace antinode::test
{
/** What a host does between blocks on the thread that made its plug-ins: on Windows it hands on that thread's messages,
    elsewhere JUCE's plug-ins have a thread of their own for them. */
void runHostLoop (std::chrono::milliseconds);
} // namespace antinode::test
