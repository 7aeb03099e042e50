#pragma once

#include <antinode_focus/FocusDesign.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** A design as design.json: the focus, what is played, its certificate, what was chosen and why. Docs/FileFormats.md.
    Modes are numbered from 0 in the order of the model. [worker] */
nlohmann::ordered_json designToJson (const FocusDesign&, const ModalModel&);

/** The program of a design.json: bit-identical to the one written.
    @param source  how errors name it
    @throws InputError  source, JSON pointer, what is wrong, what is allowed
    [worker] */
VoltageProgram readProgram (const nlohmann::json&, const std::string& source);
} // namespace antinode
