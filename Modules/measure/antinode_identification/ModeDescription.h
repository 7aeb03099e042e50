#pragma once

#include "ComplexModes.h"
#include "Identification.h"
#include "NormalModeFit.h"
#include "PoleSearch.h"

namespace antinode
{
/** E |error|^2 of a value of weight 1: as the errors are; where variances were given, at least 1. [worker] */
double estimateVariance (const NormalModeFit&, const PreparedResponses&);

/** What was fitted as what is known of it: modes in ascending frequency with their deviations, qualities and scale,
   residual terms, errors, warnings.
    @param residues  complex modes where its basis has the functions of complex modes
    @param clusters  of the fit's modes, in their order
    [worker] Docs/Theory.md, sections 8.4 and 8.5. */
IdentifiedModes describeModes (const NormalModeFit&, const FreeResidues& residues, PreparedResponses&,
                               const std::vector<PoleCluster>& clusters, const IdentificationOptions&);
} // namespace antinode
