#pragma once

#include "KnownModeFit.h"
#include "KnownModeState.h"

namespace antinode
{
/** Gauss and Newton's equations of the log posterior density. Unknowns: frequencies in half widths, relative changes of
    damping ratios, the delay; and strengths, participation over angular frequency, of each ceramic. */
struct KnownModeEquations
{
    Eigen::MatrixXd poles;                  ///< (2 N_m + 1) square, lower triangle: strengths eliminated.
    Eigen::VectorXd gradient;               ///< 2 N_m + 1: of the log posterior, strengths eliminated.
    std::vector<Eigen::MatrixXd> factors;   ///< N_b of N_m x N_m: the lower factor of each ceramic's strengths.
    std::vector<Eigen::MatrixXd> couplings; ///< N_b of N_m x (2 N_m + 2): of these with poles and gradient, whitened.
    double delayUnit = 1;                   ///< s
};

/** [worker] Docs/Theory.md, section 8.7. */
KnownModeEquations knownModeEquations (const KnownModeState&, const KnownModes&, const KnownModePrior&);

/** A step of the unknowns, and what it would gain of log posterior. */
struct KnownModeStep
{
    Eigen::VectorXd poles;     ///< 2 N_m
    Eigen::MatrixXd strengths; ///< N_m x N_b
    double delay = 0, gain = 0;
};

/** The step that gains most within a reach: half widths of a frequency, of the logarithm of a damping ratio, and for
   the delay radians of the highest mode.
    @param reach  above 0
    @return       not finite where the equations are singular
    [worker] Docs/Theory.md, section 8.7, and reference 18. */
KnownModeStep solve (const KnownModeEquations&, double reach);

/** Standard deviations of the unknowns: those of strengths with poles as they are. [worker] */
struct KnownModeDeviations
{
    Eigen::VectorXd poles;     ///< 2 N_m
    Eigen::MatrixXd strengths; ///< N_m x N_b
};

KnownModeDeviations deviationsOf (const KnownModeEquations&);
} // namespace antinode
