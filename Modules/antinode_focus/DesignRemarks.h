#pragma once

#include "FocusDesign.h"

#include <string>

namespace antinode
{
/** Adds to a design, in plain words, what was chosen and why, and what the user should be warned of. [worker] */
void addRemarks (FocusDesign&, const ModalModel&);
} // namespace antinode
