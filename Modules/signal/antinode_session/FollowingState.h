#pragma once

#include "FollowingSettings.h"

#include <antinode_text/JsonReader.h>

#include <string>

namespace antinode
{
/** How a device is followed, as states keep it: JSON. Docs/FileFormats.md [worker] */
std::string followingToText (const FollowingSettings&);

/** @throws InputError  where it is none [worker] */
FollowingSettings followingFromJson (const JsonValue&);
} // namespace antinode
