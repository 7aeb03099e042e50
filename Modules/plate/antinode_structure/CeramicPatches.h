#pragma once

#include "PlateSection.h"

#include "BendingProblem.h"

namespace antinode
{
/** A section as the solver of outlined plates wants it, SI. [any] */
BendingSection bendingSection (const PlateSection&);

/** What a ceramic adds to a plate of any outline, and where, SI: one patch or several, each with the edges that bend
   the plate and its moment per volt, which are added up. The kind of ceramic decides; the solver knows patches only.
   [any] Docs/Theory.md, section 1.13. */
std::vector<BendingPatch> ceramicPatches (const StructureCommon&, const CeramicDescription&);
} // namespace antinode
