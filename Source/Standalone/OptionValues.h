#pragma once

#include "StandaloneOptions.h"
#include "TouchHost.h"

#include <antinode_session/FollowingSettings.h>

#include <string>
#include <vector>

namespace antinode
{
/** What listens, as an option says it: "velocity:X:Y" or "displacement:X:Y", mm, "ceramic_current:N" or
    "ceramic_charge:N", N from 1, or "none".
    @throws InputError  where it is none of these [any] */
FollowingSettings readFollowing (const std::string&);

/** From a list "1,2,5" that counts from 1, 0 for none, and leaves out the last fingers, which then have none.
    @throws InputError  where it is no such list [any] */
FingerInputs readFingerInputs (const std::string& list);

/** A finger of an option: "X:Y" or "X:Y:LEVEL", mm and um.
    @throws InputError  where it is none [any] */
WantedFinger readFinger (const std::string&);

/** The notes of the options and of their MIDI file.
    @throws InputError  where one is none, or the file is none [worker] */
std::vector<TimedNote> readNotes (const StandaloneOptions&);
} // namespace antinode
