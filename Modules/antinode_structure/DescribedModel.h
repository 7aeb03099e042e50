#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** Writes into a computed model what it takes over from the description as it is: name, damping, limits, and the ceramics with their
    rectangles cut to the model's surface. [worker] */
void describe (ModalModel&, const std::string& name, const StructureCommon&);
} // namespace antinode
