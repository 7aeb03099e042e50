#pragma once

#include <antinode_session/FollowingSettings.h>

#include <string>

namespace antinode
{
/** What listens, as an option says it: "velocity:X:Y" or "displacement:X:Y", mm, "ceramic_current:N" or
    "ceramic_charge:N", N from 1, or "none".
    @throws InputError  where it is none of these [any] */
FollowingSettings readFollowing (const std::string&);
} // namespace antinode
