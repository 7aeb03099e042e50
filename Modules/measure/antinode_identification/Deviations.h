#pragma once

#include "ComplexModes.h"
#include "NormalModeFit.h"

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

/** What single points and references want of a fit: derivatives of minus half their parts of the cost with respect to
   the unknowns of FitState, the best shapes eliminated. At the end of a fit their sum is 0. U unknowns. */
struct ClusterScores
{
    std::vector<Eigen::MatrixXd> unknowns; ///< One or several divisions into clusters, U x clusters.
    Eigen::VectorXd shapeSpreads; ///< N_m: variance of shapes when references are left out one by one, over the
                                  ///< curvature's; 0 if there is one reference.
};

/** Clusters are points where there are four or more, and references where there are three or more; else channels.
    @param couplings  of the state's groups
    [worker] Docs/Theory.md, section 8.5. */
ClusterScores clusterScores (const FitState&, const std::vector<ShapeCoupling>& couplings);

/** Variances of linear functions of the unknowns from the scatter of clusters' steps: the sum of squares times n / (n -
   1); the largest of all divisions.
    @param functions  U x N
    @param inverse    U x U: of the equations' matrix
    @return           N
    [worker] */
Eigen::VectorXd clusterVariances (const std::vector<Eigen::MatrixXd>& clusters, const Eigen::MatrixXd& inverse,
                                  const Eigen::MatrixXd& functions);

/** Channels' scores, U x C, as the clusters that they belong to. [any] */
std::vector<Eigen::MatrixXd> clustered (const Eigen::MatrixXd& channelScores, const Eigen::VectorXd& columnWeights,
                                        Eigen::Index points);
} // namespace antinode
