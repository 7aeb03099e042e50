#pragma once

#include "Identification.h"
#include "PoleClusters.h"
#include "SearchBands.h"

namespace antinode
{
/** Poles found in all bands, and all that were looked at. */
struct FoundPoles
{
    std::vector<PoleCluster> clusters;   ///< Ascending in frequency: those that are taken unless the user picks.
    std::vector<PoleCluster> candidates; ///< Also poles that are seen rarely: those among which the user picks.
    std::vector<StabilisationPoint> stabilisation;
};

/** Seeks poles band by band, on as many threads as there are processors; the result does not depend on how many.
    @throws InputError  when bands that were requested hold too few lines
    [worker] Docs/Theory.md, sections 8.2 and 8.3. */
FoundPoles searchPoles (const PreparedResponses&, const IdentificationOptions&);
} // namespace antinode
