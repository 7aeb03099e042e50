#pragma once

#include <antinode_model/Ceramic.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** The object "lag" of a ceramic. @throws InputError [worker] */
InputLag readLag (const JsonValue&);

/** The same as JSON. [any] */
nlohmann::ordered_json lagToJson (const InputLag&);
} // namespace antinode
