#pragma once

#include "NormalModeFit.h"

namespace antinode
{
/** The residual of a fit, summed over some tens to hundreds of lines at a time. S spans of lines, C columns. Of what
   was measured (PreparedResponses::lineScale), without weights. */
struct FitErrors
{
    Eigen::VectorXd frequencies; ///< S: rad/s, the middle of each span.
    Eigen::VectorXd lines;       ///< S: how many lines.
    Eigen::MatrixXd energies;    ///< S x C: sum of |error|^2.
    Eigen::MatrixXd
        roughness; ///< S x C: half the sum of |error - error of the line before|^2: noise, but no smooth misfit.
    Eigen::VectorXd dataEnergies;                           ///< C: sum of |data|^2.
    Eigen::VectorXd velocityEnergies, velocityDataEnergies; ///< C: the sums over all lines, of velocities.
};

/** Coefficients of all functions of a basis: what a fit of real modes gives, functions x C. [worker] */
Eigen::MatrixXd fitCoefficients (const FitState&);

/** Data less a fit, everywhere; single missing values are replaced by what the fit gives there.
    @param coefficients  functions x C
    [worker] Docs/Theory.md, section 8.5. */
FitErrors fitErrors (PreparedResponses&, const ModalBasis&, const Eigen::MatrixXd& coefficients, double delay);

/** Weights 1 / variance from what a fit leaves: a product of one for each line, point and reference. Where variances
   were given they stay, as far as the errors confirm them. [worker] Docs/Theory.md, section 8.5. */
void weighByErrors (PreparedResponses&, const FitErrors&);
} // namespace antinode
