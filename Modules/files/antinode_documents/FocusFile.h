#pragma once

#include <antinode_focus/FocusDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** A focus from JSON. Docs/FileFormats.md.
    @param source  how errors name it
    @throws InputError  source, JSON pointer, what is wrong, what is allowed, "did you mean"
    [worker] */
FocusDescription readFocus (const nlohmann::json&, const std::string& source);

/** A focus as JSON that readFocus reads: what was left to choice stays out. [worker] */
nlohmann::ordered_json focusToJson (const FocusDescription&);
} // namespace antinode
