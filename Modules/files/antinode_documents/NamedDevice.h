#pragma once

#include <antinode_text/JsonReader.h>

#include <optional>
#include <string>

namespace antinode
{
/** The device that a focus or waveforms are for, their entry `device`: a name or a file; empty: none is named.
    @throws InputError  where the entry is no text, or empty
    [worker] */
std::string readNamedDevice (const std::optional<JsonValue>& device);
} // namespace antinode
