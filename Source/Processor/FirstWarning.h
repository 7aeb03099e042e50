#pragma once

#include <antinode_session/UserMessages.h>

#include <juce_core/juce_core.h>

#include <vector>

namespace antinode
{
/** The first message that is a warning, or empty. [any] */
juce::String firstWarning (const std::vector<UserMessage>&);
} // namespace antinode
