#pragma once

#include "Identification.h"

namespace antinode
{
/** Modes as the paper identified them: peaks of the summed squared responses, damping from their half-power widths,
   shapes and participations from the values at the peaks. Neither deviations nor residual terms; for comparison.
    @throws InputError  when there is no peak
    [worker] Docs/Theory.md, section 8.3; paper, section 5. */
IdentifiedModes pickPeaks (const FrequencyResponses&, const IdentificationOptions&);
} // namespace antinode
