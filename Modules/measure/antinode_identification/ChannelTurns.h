#pragma once

#include <Eigen/Core>

namespace antinode
{
/** What may turn the phases of all residues of some channels, by one number each. */
enum class ChannelTurn
{
    delay,   ///< s
    lowPass, ///< s: the time constant of a low-pass of first order, at least 0.
    shift    ///< Of resonances, relative.
};

/** Phases of residues of channels in groups, doubled so that signs of shapes do not matter. N_m modes, G groups. */
struct GroupedPhases
{
    Eigen::VectorXd omega, damping; ///< N_m: of the modes.
    Eigen::MatrixXcd sums;          ///< N_m x G: of exp (2 i phase) times weights.
    double weights = 0;             ///< The sum of all of these.
};

/** What turns phases of each group most towards 0 or pi. */
struct TurnsOfGroups
{
    Eigen::VectorXd values; ///< G: what is to be removed.
    Eigen::VectorXd gains;  ///< G: by how much the sum falls for each.
    double left = 0;        ///< Weighted sum of squared sines of the phases that are left.
};

/** Beside the turns of groups there is one delay of all. [worker] Docs/Theory.md, section 8.5. */
TurnsOfGroups bestTurns (const GroupedPhases&, ChannelTurn);
} // namespace antinode
