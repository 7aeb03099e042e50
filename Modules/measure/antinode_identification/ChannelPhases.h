#pragma once

#include "IdentifiedModes.h"
#include "NormalModes.h"

#include <Eigen/Core>

namespace antinode
{
/** How the phases of one channel's residues follow frequency: by a delay, s, or a low-pass of first order, rad/s. */
struct ChannelPhase
{
    double delay = 0, corner = 0;
    double score = 0; ///< Share of the residues' amplitude that is real then, 1 to -1.
};

/** Residues of each channel on its own at the poles that were found, the common delay taken out, N_m x C. [worker] */
Eigen::MatrixXcd channelResidues (const FrequencyResponses&, const IdentifiedModes&);

/** The score of residues as they are. @param residues N_m: of one channel [any] */
double realShare (const Eigen::VectorXcd& residues);

/** The delay, and the corner of a low-pass, that make one channel's residues as real as can be. Doubled phases do not
   see the signs of shapes.
    @param omega  N_m: rad/s, of the modes
    [worker] Docs/Theory.md, section 8.5. */
ChannelPhase bestDelay (const Eigen::VectorXcd& residues, const Eigen::VectorXd& omega);
ChannelPhase bestLowPass (const Eigen::VectorXcd& residues, const Eigen::VectorXd& omega);

/** How far the two by two tables of each channel agree with those of other points and references, 1 to -1: of one shape
   times one participation every determinant is 0, and an inverted channel makes it twice a product.
    @param residues  N_m x C
    @return          C; 1 where there is no other point or reference
    [worker] Docs/Theory.md, section 8.5. */
Eigen::VectorXd channelAgreements (const Eigen::MatrixXcd& residues, Eigen::Index points);

/** Below, a channel is inverted against the others. */
constexpr double oppositeAgreement = -0.3;

/** Whether the phases of residues are those of channels, a delay or a low-pass each or a quarter turn of all, rather
   than of modes.
    @param residues  N_m x C @param columnWeights  C
    [worker] Docs/Theory.md, section 8.5. */
bool phasesAreOfChannels (const Eigen::MatrixXcd& residues, const Eigen::VectorXd& omega,
                          const Eigen::VectorXd& columnWeights);

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
