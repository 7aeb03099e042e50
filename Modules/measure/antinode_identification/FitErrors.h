#pragma once

#include "Identification.h"
#include "IdentifiedModes.h"
#include "NormalModeFit.h"
#include "PreparedResponses.h"

#include <string>

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

/** What modes alone leave of measured velocities, without residual terms. */
struct ModalRest
{
    double error = 0; ///< RMS over RMS of measured, dB, on the lines of the data.

    /** N_p x N_b: how far modes above the band bend the points per drive, far below it, m/V or m/N: least squares on
       the lower part of the band, beside the inertia of lower modes and the onset of higher ones. NaN where it is not
        measured. Residual terms, which fit all of the band, take it up to twice as large. */
    Eigen::MatrixXd staticShare;
};

/** [worker] Docs/Theory.md, section 8.4. */
ModalRest modalRest (const IdentifiedModes&, const PreparedResponses&);

/** Two dB figures of the error between two frequencies added: that of the energy as it is, and that of spans of lines
   which count alike, however weak they are. The lower the better.
    @throws Cancelled  as checkWatch()
    [worker] */
double errorBetween (const FrequencyResponses&, const IdentifiedModes&, const FrequencyBand&);

/** Where most of the error lies, and what may help, as a sentence.
    @throws Cancelled  as checkWatch()
    [worker] */
std::string sayWhere (const FrequencyResponses&, const IdentifiedModes&);
} // namespace antinode
