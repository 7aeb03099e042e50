#pragma once

#include "DeviceDescription.h"

#include <optional>

namespace antinode
{
/** A plate of any outline, solved and put on a grid. @throws InputError [worker] Docs/Theory.md, section 1.13. */
ModalModel solveOutlinedPlate (const std::string& name, const OutlinedPlate&, std::optional<int> modeCount);
} // namespace antinode
