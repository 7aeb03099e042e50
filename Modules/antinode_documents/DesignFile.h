#pragma once

#include <antinode_focus/FocusDesign.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** A design as design.json: the focus, what is played, its certificate, what was chosen and why. Docs/FileFormats.md.
    Modes are numbered from 1 in the order of the model. [worker] */
nlohmann::ordered_json designToJson (const FocusDesign&, const ModalModel&);
} // namespace antinode
