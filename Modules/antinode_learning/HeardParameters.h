#pragma once

#include "LearningParameters.h"

namespace antinode
{
/** The parameters that recordings say anything of: what would change the signals by less than a tenth of their noise,
   if it were one standard deviation off, is left as it is.
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 7.6. */
LearningParameters heardParameters (const LearningPrior&);
} // namespace antinode
