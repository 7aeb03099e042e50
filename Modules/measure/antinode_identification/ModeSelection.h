#pragma once

#include "ComplexModes.h"
#include "NormalModeFit.h"
#include "PoleSearch.h"

namespace antinode
{
/** The candidates picked by the user: those nearest to the selected frequencies, if there are any, without those
   nearest to the rejected ones.
    @throws InputError  when no candidate lies within 2 % of a frequency
    [worker] */
std::vector<PoleCluster> picked (const std::vector<PoleCluster>&, const IdentificationOptions&);

/** Modes whose energy noise alone would not give, in ascending order; of neighbours that fail together the stronger
   stays for now.
    @param variance  E |error|^2 of a value of weight 1
    [worker] Docs/Theory.md, section 8.5. */
std::vector<Eigen::Index> standOut (const FitState&, double variance, double ridge);

/** The poles of clusters as modes without shapes. @param delay  s [any] */
NormalModes polesOf (const std::vector<PoleCluster>&, double delay);

/** Only some of the clusters, or modes, in ascending frequency. [any] */
std::vector<PoleCluster> chosen (const std::vector<PoleCluster>&, const std::vector<Eigen::Index>&);
NormalModes chosen (const NormalModes&, const std::vector<Eigen::Index>&);

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
