#pragma once

#include "IdentifiedModes.h"
#include "NormalEquations.h"

namespace antinode
{
/** Puts complex shapes and participations beside the real ones: the strongest product of free complex residues. Residual terms become
    those that belong to them.
    @param residues  N_m x C: phi alpha, complex, without delay
    [worker] Docs/Theory.md, section 8.4. */
void addComplexModes (IdentifiedModes&, const FitState&, const Eigen::MatrixXcd& residues, const PreparedResponses&);
} // namespace antinode
