#pragma once

#include "FocusDesign.h"

#include <string>

namespace antinode
{
/** A number as a person would write it: four significant digits, no exponent where it can be avoided. [any] */
std::string inWords (double value);

/** Adds to a design, in plain words, what was chosen and why, and what the user should be warned of. [worker] */
void addRemarks (FocusDesign&, const ModalModel&);
} // namespace antinode
