#pragma once

#include "FocusDesign.h"

#include <string>

namespace antinode
{
/** Adds to a design, as sentences, what was chosen and why, and warnings for the user. [worker] */
void addRemarks (FocusDesign&, const ModalModel&);
} // namespace antinode
