#pragma once

#include "PlacementCandidates.h"

namespace antinode
{
/** Positions from one end to the other, symmetric about the middle, at most one step apart. @throws InputError  where
   the step is none, or they are more than 5000 [any] */
std::vector<double> candidatePositions (double from, double to, double step);

/** @throws InputError  where there are more than 5000 candidates [any] */
void requireFewCandidates (std::size_t count);

/** The candidates on a plate of any outline without ceramics: even positions at which a ceramic lies within it, on no
   point support or mass, away from all edges as a margin from free ones asks where that leaves any, with their
   participations.
    @throws InputError  as placementCandidates [worker] Docs/Theory.md, section 1.9. */
PlacementCandidates outlinedCandidates (const OutlinedPlate&, const CeramicDescription& like, const CandidateGrid&);

/** Gives candidates the frequencies, losses and moments per volt of soft layers and of thick plates.
    @param common  as solved
    [worker] Docs/Theory.md, sections 1.7 and 1.15. */
void correctCandidates (PlacementCandidates&, StructureCommon common, const CeramicDescription& like);
} // namespace antinode
