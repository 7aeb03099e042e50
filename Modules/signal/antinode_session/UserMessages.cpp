#include "UserMessages.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cstdio>

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

namespace
{
constexpr int maximumRanges = 6;  // that are named
constexpr int ignorablePart = 10; // of the notes: one in so many

/** "0 to 3, 9 and 127", the last ones in a number where there are many. */
std::string inWords (const std::vector<int>& notes)
{
    std::vector<std::string> ranges;
    std::size_t named = 0;

    while (named < notes.size() && ranges.size() < maximumRanges)
    {
        const auto first = named++;

        while (named < notes.size() && notes[named] == notes[named - 1] + 1)
            ++named;

        ranges.push_back (std::to_string (notes[first])
                          + (named - first > 1 ? " to " + std::to_string (notes[named - 1]) : ""));
    }

    if (named < notes.size())
        ranges.push_back (std::to_string (notes.size() - named) + " more");

    std::string text;

    for (std::size_t i = 0; i < ranges.size(); ++i)
        text += (i == 0 ? "" : i + 1 == ranges.size() ? " and " : ", ") + ranges[i];

    return text;
}
} // namespace

std::string unplayableNotes (const DesignProgress& progress, double sampleRate)
{
    const auto& notes = progress.failedNotes;

    if (notes.empty())
        return {};

    char rate[32];
    std::snprintf (rate, sizeof rate, "%g", sampleRate / 1000);
    return std::to_string (notes.size()) + " of " + std::to_string (progress.wanted - 1) + " notes cannot be played at "
           + rate + " kHz (" + (notes.size() == 1 ? "note " : "notes ") + inWords (notes) + "): " + progress.error;
}

UserMessage unplayableNotesMessage (const DesignProgress& progress, double sampleRate)
{
    const auto failed = static_cast<int> (progress.failedNotes.size());
    return { ignorablePart * failed <= progress.wanted ? Urgency::calm : Urgency::caution,
             unplayableNotes (progress, sampleRate) };
}

namespace
{
std::string driftOf (const FollowingStatus& status)
{
    if (status.trace.empty())
        return "nothing was heard yet";

    const auto& newest = status.trace.back();
    return formatted ("%+.2f %% (+-%.0f ppm)", 100 * newest.common, micro * newest.deviation);
}

std::string withReason (const std::string& sentence, const std::string& reason)
{
    return reason.empty() ? sentence : sentence + " " + reason;
}
} // namespace

std::string followingSentence (const FollowingStatus& status)
{
    switch (status.state)
    {
        case FollowingState::off:
            return "No sensor is chosen.";
        case FollowingState::waiting:
            return "Waiting: play something that the sensor hears.";
        case FollowingState::silent:
            return "Silent: too little is played; last " + driftOf (status) + ".";
        case FollowingState::lost:
            return withReason ("Lost:", status.reason);
        case FollowingState::frozen:
            return "Frozen: " + driftOf (status) + ".";
        case FollowingState::paused:
            return withReason ("Paused: " + driftOf (status) + ".", status.reason);
        case FollowingState::impossible:
            return withReason ("Not possible:", status.reason);
        case FollowingState::following:
            break;
    }

    return withReason ("Following: " + driftOf (status)
                           + formatted (", %.2f ms after the voltages.", milli * status.delay),
                       status.reason);
}

UserMessage followingMessage (const FollowingStatus& status)
{
    const auto fails = status.state == FollowingState::lost || status.state == FollowingState::impossible;
    return fails ? UserMessage { Urgency::caution, "Following of the drift: " + followingSentence (status) }
                 : UserMessage {};
}
} // namespace antinode
