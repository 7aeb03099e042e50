#pragma once

#include "IdentifiedModes.h"
#include "NormalEquations.h"

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
} // namespace antinode
