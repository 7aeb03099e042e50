#pragma once

#include "TrackingStatus.h"
#include "UserMessages.h"

#include <antinode_base/WordList.h>

#include <string>

namespace antinode
{
/** What programs call the states. */
inline constexpr WordList<TrackingState, 8> trackingStateWords { { { "off", TrackingState::off },
                                                                   { "waiting", TrackingState::waiting },
                                                                   { "following", TrackingState::following },
                                                                   { "silent", TrackingState::silent },
                                                                   { "lost", TrackingState::lost },
                                                                   { "frozen", TrackingState::frozen },
                                                                   { "paused", TrackingState::paused },
                                                                   { "impossible", TrackingState::impossible } } };

/** What tracking says of a device, for people: "Following: +0.42 % (+-12 ppm), 5.31 ms after the voltages". [any] */
std::string trackingSentence (const TrackingStatus&);

/** The same where tracking does not do what it is wanted for; else without text. [any] */
UserMessage trackingMessage (const TrackingStatus&);
} // namespace antinode
