#pragma once

#include "ElementResults.h"

#include <antinode_responses/UniversalSets.h>

namespace antinode
{
/** Nodes (15, 2411), elements (2412), and of sets 55 and 2414: normal modes and complex ones, static displacements, and
    reaction forces, which are those of a held body; in SI units where a set 164 says which units the file has.
    @throws InputError  source, what is wrong
    [worker] Docs/Manual/importing.md */
ElementResults universalResults (const std::vector<UniversalSet>&, const std::string& source);
} // namespace antinode
