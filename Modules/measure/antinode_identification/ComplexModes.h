#pragma once

#include "FitErrors.h"
#include "Identification.h"
#include "IdentifiedModes.h"
#include "NormalModeFit.h"

#include <optional>
#include <string>

namespace antinode
{
/** Modes whose residues are free: any complex number for each point and reference, by least squares; only the poles are
    common. */
struct FreeResidues
{
    ModalBasis basis; ///< With the fitted poles.
    ModalProducts products;
    Eigen::MatrixXcd residues; ///< N_m x C: phi alpha, complex.
    bool isConverged = true;   ///< Whether no step of the poles promises more than 1e-7 of the cost.
};

/** Fits the poles by Gauss and Newton's method, residues and powers eliminated (variable projection). What structures
   whose damping is not proportional need; where modes are real it knows less than the fit of normal modes.
    @param start  its poles, and the delay that is taken out of the data
    [worker] Docs/Theory.md, section 8.4; Golub and Pereyra, SIAM Journal on Numerical Analysis 10 (1973) 413. */
FreeResidues fitFreeResidues (const PreparedResponses&, const NormalModes& start, double ridge);

/** The same for the poles of real modes as they are. [worker] */
FreeResidues freeResidues (const FitState&, double ridge);

/** Equations of all poles of free residues, residues and powers eliminated: frequencies in half widths, then dampings
   relative to themselves. */
struct PoleEquations
{
    Eigen::MatrixXd matrix; ///< 2 N_m x 2 N_m
    Eigen::MatrixXd scores; ///< 2 N_m x C: of minus half of each channel's part of the cost.
    double cost = 0;
};

/** At the poles of a basis with complexModeFunctions. [worker] Docs/Theory.md, section 8.4. */
PoleEquations poleEquations (const ModalBasis&, const ModalProducts&, const Eigen::VectorXd& columnWeights,
                             double ridge);

/** What free residues leave at poles as they are: the weighted sum of squared errors. [worker] */
double freeCost (const FreeResidues&, const Eigen::VectorXd& columnWeights, double ridge);

/** Adds complex shapes and participations to the real ones: the strongest product of the free residues of each mode.
   Residual terms become those that belong to them.
    @return  coefficients of all functions of the basis for these modes, functions x C
    [worker] Docs/Theory.md, section 8.4. */
Eigen::MatrixXd addComplexModes (IdentifiedModes&, const FreeResidues&, const PreparedResponses&);

/** Whether a device's modes are complex, and why. */
struct ModeKind
{
    bool areComplex = false;
    std::string reason; ///< A sentence.
};

/** What F with so many numbers, and many more values, exceeds with a probability of 0.1 %: Wilson and Hilferty's cube.
    [any] */
double limitOfRatio (double numbers);

/** Whether complex modes are worth a fit: real ones leave more than rounding and traces, and free
   residues at the same poles leave less by more than noise.
    @return  nothing if they are, else the reason why modes are real
    [worker] Docs/Theory.md, section 8.4. */
std::optional<ModeKind> evidentlyReal (const NormalModeFit&, const FreeResidues&, const PreparedResponses&,
                                       double ridge);

/** Whether modes are complex: by an F test of the errors of both fits, with a risk of 0.1 % to call real modes complex
   under white noise; if complex shapes explain at least two thirds of what real ones leave above the noise; and if the
   phases are not those of channels.
    @param realErrors, complexErrors  of the best fits of the same modes
    @param complexFit                 its free residues, behind the delay
    [worker] Docs/Theory.md, section 8.4; Docs/Design/identification.md */
ModeKind decideModeKind (const FitErrors& realErrors, const FitErrors& complexErrors, const FreeResidues& complexFit,
                         double delay, const PreparedResponses&);

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
