#include "FirstWarning.h"

#include <algorithm>

namespace antinode
{
juce::String firstWarning (const std::vector<UserMessage>& messages)
{
    const auto found = std::find_if (messages.begin(), messages.end(),
                                     [] (const auto& message) { return message.urgency == Urgency::warning; });
    return found == messages.end() ? juce::String() : juce::String::fromUTF8 (found->text.c_str());
}
} // namespace antinode
