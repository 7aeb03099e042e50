#pragma once

#include "ComplexModes.h"
#include "NormalModeFit.h"

namespace antinode
{
/** Energy of each mode over what noise alone would give its shape, as amplitudes: about 1 where there is no mode.
    @param variance  E |error|^2 of a value of weight 1
    @return          N_m
    [worker] Docs/Theory.md, section 8.5. */
Eigen::VectorXd signalToNoise (const FitState&, double variance, double ridge);

/** Covariances of real and imaginary part of each mode's free residues, of a channel of weight 1.
    @param variance  E |error|^2 of a value of weight 1
    [worker] Docs/Theory.md, section 8.5. */
std::vector<Eigen::Matrix2d> residueCovariances (const FreeResidues&, double variance, double ridge);

/** How well one shape times one participation explains the free residues of each mode, and how collinear they are in
   the complex plane; what noise alone does to both is taken out.
    @param variance  E |error|^2 of a value of weight 1 that is noise
    [worker] Docs/Theory.md, section 8.5. */
std::vector<ModeQuality> assessResidues (const FreeResidues&, const PreparedResponses&, double variance, double ridge);

/** Adds warnings about single modes and about the whole identification, as sentences, to those that exist. [worker] */
void addWarnings (IdentifiedModes&);
} // namespace antinode
