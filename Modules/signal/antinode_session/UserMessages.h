#pragma once

#include "DesignRequest.h"
#include "Following.h"

#include <antinode_base/Reflection.h>

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

/** Says how many notes have no focus, which, and why the last of them failed; empty if all have one. The focus at its
   own position is not meant: DesignProgress::liveError.
    @param sampleRate  that they were designed for, Hz
    [any] */
std::string unplayableNotes (const DesignProgress&, double sampleRate);

/** The same for a window: calm while nearly all others play, for that may be ignored. [any] */
UserMessage unplayableNotesMessage (const DesignProgress&, double sampleRate);

/** What programs call the states. */
inline constexpr WordList<FollowingState, 8> followingStateWords { { { "off", FollowingState::off },
                                                                     { "waiting", FollowingState::waiting },
                                                                     { "following", FollowingState::following },
                                                                     { "silent", FollowingState::silent },
                                                                     { "lost", FollowingState::lost },
                                                                     { "frozen", FollowingState::frozen },
                                                                     { "paused", FollowingState::paused },
                                                                     { "impossible", FollowingState::impossible } } };

/** What following says of a device, for people: "Following: +0.42 % (+-12 ppm), 5.31 ms after the voltages". [any] */
std::string followingSentence (const FollowingStatus&);

/** The same where following does not do what it is wanted for; else without text. [any] */
UserMessage followingMessage (const FollowingStatus&);
} // namespace antinode
