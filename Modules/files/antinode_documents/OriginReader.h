#pragma once

#include <antinode_model/ModeOrigin.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** The key of a device that says where its modes come from. */
inline constexpr auto originKey = "origin";

/** @throws InputError [worker] Docs/FileFormats.md. */
ModeOrigin readOrigin (const JsonValue&);

/** The same as JSON. [any] */
nlohmann::ordered_json originToJson (const ModeOrigin&);
} // namespace antinode
