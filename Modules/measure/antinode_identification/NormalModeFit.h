#pragma once

#include "NormalEquations.h"

namespace antinode
{
/** The result of a maximum-likelihood fit of real normal modes. */
struct NormalModeFit
{
    NormalModes modes;
    FitState state;  ///< At its end.
    double cost = 0; ///< Weighted sum of squared errors.
    int iterations = 0;
    bool isConverged = false; ///< Whether no step is worth the precision that was asked for.
};

/** The start of a fit and its free unknowns. */
struct NormalModeStart
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::MatrixXd participation;                     ///< N_m x N_b
    double delay = 0;
    bool delayIsKnown = false;
};

/** All poles, shapes, participations and the common delay at once, by Levenberg and Marquardt's method. Shapes and
   residual terms are eliminated in each step (variable projection), so that only sums over frequencies and points
   remain.
    @param ridge      relative, on the diagonal of the normal equations
    @param precision  it ends where a step would be worth less than this many squared standard deviations
    @param maximum       iterations
    @return           look at isConverged
    [worker] Docs/Theory.md, section 8.4. */
NormalModeFit fitNormalModes (const PreparedResponses&, const NormalModeStart&, double ridge, double precision,
                              int maximum);

/** Makes equations regular: fixes the lengths of participations, which the data leave free, and the delay where it is
   known. [worker] Docs/Theory.md, section 8.4. */
void holdWhatIsNotSeen (NormalEquations&, const FitState&, bool delayIsKnown);

/** The start of a fit from unconstrained residues: the strongest product of shape and participation of each mode.
    @param residues  N_m x C, phi alpha
    @return          participations, N_m x N_b
    [worker] */
Eigen::MatrixXd strongestParticipation (const Eigen::MatrixXd& residues, const PreparedResponses&);
} // namespace antinode
