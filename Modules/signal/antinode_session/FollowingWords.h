#pragma once

#include "FollowingStatus.h"
#include "UserMessages.h"

#include <antinode_base/WordList.h>

#include <string>

namespace antinode
{
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
