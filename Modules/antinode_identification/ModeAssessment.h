#pragma once

#include "IdentifiedModes.h"
#include "NormalModeFit.h"

namespace antinode
{
/** Energy of each mode over what noise alone would give its shape, as amplitudes: about 1 where there is no mode.
    @param variance  E |error|^2 of a value of weight 1
    @return          N_m
    [worker] Docs/Theory.md, section 8.5. */
Eigen::VectorXd signalToNoise (const FitState&, double variance, double ridge);

/** How well the free residues of each mode are one shape times one participation, and how well they lie on a line in the complex plane.
    @param residues   N_m x C: phi alpha, complex, without delay
    [worker] Docs/Theory.md, section 8.5. */
std::vector<ModeQuality> assessResidues (const Eigen::MatrixXcd& residues, const PreparedResponses&);

/** What is doubtful about modes and the whole, in plain words, put beside what is doubted already. [worker] */
void addDoubts (IdentifiedModes&);
} // namespace antinode
