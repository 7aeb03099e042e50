#pragma once

#include "NormalEquations.h"

namespace antinode
{
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
