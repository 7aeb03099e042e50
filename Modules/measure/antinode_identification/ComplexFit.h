#pragma once

#include "Identification.h"
#include "ModeKind.h"

#include <optional>

namespace antinode
{
/** The fit of complex modes, where they are asked for or a test finds them; none where modes are real.
    @param fit       of real modes
    @param residues  free ones at its poles
    @param kind      becomes what the test decided; stays as it is where options decide
    [worker] Docs/Design/identification.md */
std::optional<FreeResidues> fitComplexModes (const NormalModeFit& fit, const FreeResidues& residues, PreparedResponses&,
                                             const IdentificationOptions&, ModeKind& kind);

/** What complex modes of that fit leave. [worker] */
FitErrors complexErrors (const NormalModeFit&, const FreeResidues& complexFit, PreparedResponses&);

/** Modes with the poles of a basis. [any] */
NormalModes withPoles (NormalModes, const ModalBasis&);
} // namespace antinode
