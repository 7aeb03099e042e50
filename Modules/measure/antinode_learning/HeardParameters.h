#pragma once

#include "LearningParameters.h"

namespace antinode
{
/** The parameters that the data say anything of, recordings where there are any: those of which they have at least a
   tenth of the prior's information. The others are left as they are.
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 7.6. */
LearningParameters heardParameters (const LearningPrior&);
} // namespace antinode
