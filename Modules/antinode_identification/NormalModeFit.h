#pragma once

#include "NormalModes.h"

namespace antinode
{
/** What a maximum-likelihood fit of real normal modes gave. */
struct NormalModeFit
{
    NormalModes modes;
    Eigen::MatrixXd residualCoefficients; ///< Odd powers x C: of (i omega / scale)^power.
    ModalBasis basis;                     ///< With the fitted poles.
    double cost = 0;                      ///< Weighted sum of squared errors.
    int iterations = 0;
};

/** What a fit starts from and may change. */
struct NormalModeStart
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::MatrixXd participation;                     ///< N_m x N_b
    double delay = 0;
    bool delayIsKnown = false;
};

/** All poles, shapes, participations and the common delay at once, by Levenberg and Marquardt's method. Shapes and residual terms
    are eliminated in each step (variable projection), so that only sums over frequencies and points remain.
    @param ridge  relative, on the diagonal of the normal equations
    [worker] Docs/Theory.md, section 8.4. */
NormalModeFit fitNormalModes (const PreparedResponses&, const NormalModeStart&, double ridge);

/** Standard deviations at the end of a fit, where weights are reciprocal variances.
    [worker] Docs/Theory.md, section 8.5. */
struct NormalModeDeviations
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::MatrixXd shapes;                            ///< N_p x N_m, at fixed length of the shape.
    Eigen::MatrixXd participation;                     ///< N_m x N_b, at fixed length of the shape.
    double delay = 0;
};
NormalModeDeviations deviationsOf (const PreparedResponses&, const NormalModes&, double ridge);

/** The start of a fit from unconstrained residues: the strongest product of shape and participation of each mode.
    @param residues  N_m x C, phi alpha
    @return          participations, N_m x N_b
    [worker] */
Eigen::MatrixXd strongestParticipation (const Eigen::MatrixXd& residues, const PreparedResponses&);
} // namespace antinode
