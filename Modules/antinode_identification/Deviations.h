#pragma once

#include "IdentifiedModes.h"
#include "NormalEquations.h"

namespace antinode
{
/** Standard deviations at the end of a fit: the Cramer-Rao bound of its model. Those of shapes leave out what uncertain
   poles of other modes add.
    @param variance      E |error|^2 of a value of weight 1
    @param delayIsKnown  whether it was not fitted
    [worker] Docs/Theory.md, section 8.5. */
ModeDeviations computeDeviations (const FitState&, double variance, bool delayIsKnown, double ridge);
} // namespace antinode
