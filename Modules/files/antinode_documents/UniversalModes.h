#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_responses/UniversalSets.h>

namespace antinode
{
/** The modes of a model as universal data sets, as modal analysis programs read them: 151 header, 164 units (SI), 15
   nodes, 82 trace lines, and a 55 a mode with its frequency, damping ratio and mass-normalised shape.

    Nodes and modes are numbered from 1, as the format asks. What a mode gives for a volt has no place in it. There are
   no dates. [worker] Docs/FileFormats.md. */
std::vector<UniversalSet> modeSets (const ModalModel&);
} // namespace antinode
