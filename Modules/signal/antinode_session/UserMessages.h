#pragma once

#include <string>
#include <vector>

namespace antinode
{
enum class Urgency
{
    calm,    ///< Progress, or what may be ignored.
    caution, ///< Something is not as it should be, but what is wanted plays.
    warning  ///< What is wanted does not play.
};

/** A sentence for the user that stands as long as its cause. */
struct UserMessage
{
    Urgency urgency = Urgency::calm;
    std::string text;

    bool operator== (const UserMessage&) const = default;
};

/** Adds a message that has a text. [any] */
void addMessage (std::vector<UserMessage>&, Urgency, const std::string& text);

/** The text of the first warning among them, or empty. [any] */
std::string firstWarning (const std::vector<UserMessage>&);

/** The worst first, those of equal urgency in their order, each text once. [any] */
std::vector<UserMessage> worstFirst (std::vector<UserMessage>);
} // namespace antinode
