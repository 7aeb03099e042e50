#pragma once

#include "FocusDesign.h"

#include <string>

namespace antinode
{
/** Adds to a design, as sentences, what was chosen and why, and warnings for the user. [worker] */
void addRemarks (FocusDesign&, const ModalModel&);

/** Warns where, in closed form, the field at a focus misses what the controlled modes represent by more than 5 %.
    [worker] */
void addTransientRemark (FocusDesign&, const ModalModel&);
} // namespace antinode
