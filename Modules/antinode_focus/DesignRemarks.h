#pragma once

#include "FocusDesign.h"

#include <string>

namespace antinode
{
/** A number for messages: four significant digits, no exponent where it can be avoided. [any] */
std::string inWords (double value);

/** Adds to a design, as sentences, what was chosen and why, and warnings for the user. [worker] */
void addRemarks (FocusDesign&, const ModalModel&);
} // namespace antinode
