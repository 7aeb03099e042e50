#pragma once

#include "ElementResults.h"

#include <antinode_responses/UniversalFile.h>

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

/** Nodes (15, 2411), elements (2412), and of sets 55 and 2414: normal modes and complex ones, static displacements, and
    reaction forces, which are those of a held body; in SI units where a set 164 says which units the file has.
    @throws InputError  source, what is wrong
    [worker] Docs/Manual/importing.md */
ElementResults universalResults (const std::vector<UniversalSet>&, const std::string& source);
} // namespace antinode
