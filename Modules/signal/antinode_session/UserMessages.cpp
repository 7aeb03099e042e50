#include "UserMessages.h"

#include <algorithm>

namespace antinode
{
void addMessage (std::vector<UserMessage>& messages, Urgency urgency, const std::string& text)
{
    if (! text.empty())
        messages.push_back ({ urgency, text });
}

std::string firstWarning (const std::vector<UserMessage>& messages)
{
    const auto found = std::find_if (messages.begin(), messages.end(),
                                     [] (const auto& message) { return message.urgency == Urgency::warning; });
    return found == messages.end() ? std::string() : found->text;
}

std::vector<UserMessage> worstFirst (std::vector<UserMessage> messages)
{
    std::stable_sort (messages.begin(), messages.end(),
                      [] (const auto& one, const auto& other) { return one.urgency > other.urgency; });
    std::vector<UserMessage> once;

    for (auto& message : messages)
        if (std::none_of (once.begin(), once.end(), [&] (const auto& said) { return said.text == message.text; }))
            once.push_back (std::move (message));

    return once;
}
} // namespace antinode
