#pragma once

#include "ComplexModes.h"

namespace antinode
{
/** Standard deviations of two kinds. */
struct StatedDeviations
{
    ModeDeviations noise;  ///< Of noise alone: the Cramer-Rao bound.
    ModeDeviations stated; ///< The larger of this and what points and references show by disagreeing.
};

/** E |error|^2 of a value of weight 1. */
struct ErrorVariances
{
    double left = 1;  ///< Of all that a fit leaves: noise and misfit.
    double noise = 1; ///< Of noise alone, the smaller one.
};

/** Both at the end of a fit. Deviations that hold under misfit are those of clusters' scores (a sandwich estimator);
    where there are too few responses for clusters, misfit counts as noise.
    @param delayIsKnown  whether it was not fitted
    [worker] Docs/Theory.md, section 8.5; Liang and Zeger, Biometrika 73 (1986) 13. */
StatedDeviations stateDeviations (const FitState&, const ErrorVariances&, bool delayIsKnown, double ridge);

/** Those of complex modes: poles by the fit of free residues; the others, of real modes with the same poles, are scaled
   to the variance that complex modes leave.
    @param ofReal, realVariances  of these real modes @param variances  of complex modes
    [worker] Docs/Theory.md, section 8.5. */
StatedDeviations statedForComplex (StatedDeviations ofReal, const ErrorVariances& realVariances, const FreeResidues&,
                                   const ErrorVariances& variances, const PreparedResponses&, double ridge);

/** Standard deviations at the end of a fit: the Cramer-Rao bound of its model. Those of shapes leave out what uncertain
   poles of other modes add.
    @param variance      E |error|^2 of a value of weight 1
    @param delayIsKnown  whether it was not fitted
    [worker] Docs/Theory.md, section 8.5. */
ModeDeviations computeDeviations (const FitState&, double variance, bool delayIsKnown, double ridge);
} // namespace antinode
