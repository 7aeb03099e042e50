#pragma once

#include "ElementResults.h"

#include <string_view>

namespace antinode
{
/** An ASCII .frd file of CalculiX: nodes, elements, modes (steps of *FREQUENCY), and of static steps displacements, and
    reaction forces where all displacements are 0 or not written. @throws InputError  source, line, what is wrong
   [worker] */
ElementResults readCalculixResults (std::string_view bytes, const std::string& source);

/** The total mass in a .dat file: the largest of the three translations in TOTAL EFFECTIVE MASS. 0 where there is none.
    [worker] */
double calculixMass (std::string_view bytes);
} // namespace antinode
