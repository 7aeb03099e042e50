#pragma once

#include "BendingModes.h"

namespace antinode
{
/** The modes and, for every patch with a moment, one more shape behind them, so that together they have the whole
   static deflection under these moments, but for rigid motions. Those shapes are right far below their frequencies
   only.
    @throws InputError  where the modes are too few for what they leave to be found
    [worker] Docs/Theory.md, section 1.8. */
BendingModes withStaticRest (const BendingProblem&, BendingModes);
} // namespace antinode
