#pragma once

#include "KnownModes.h"
#include "PreparedResponses.h"

namespace antinode
{
/** What is known before a fit of known modes: most probable values and standard deviations. */
struct KnownModePrior
{
    Eigen::VectorXd angularFrequencies, frequencySpreads; ///< N_m: rad/s; relative.
    Eigen::VectorXd dampingRatios;                        ///< N_m
    double dampingSpread = 0;                             ///< Relative.
    Eigen::MatrixXd participation;                        ///< N_m x N_b
    Eigen::MatrixXd participationSpreads;                 ///< N_m x N_b: absolute.
};

/** Known modes as a measurement and what was known before say that they are. */
struct KnownModeFit
{
    KnownModes modes;
    double delay = 0;                                       ///< s
    Eigen::VectorXd frequencyDeviations, dampingDeviations; ///< N_m: relative, standard deviations of what is left.
    Eigen::VectorXd participationDeviations;                ///< N_m: of the RMS participation, relative to it.
    Eigen::VectorXd participationScales;                    ///< N_b: of each ceramic, against what was known.
    Eigen::VectorXd pointErrors;    ///< N_p: what is left of each point's responses, RMS over RMS.
    double reconstructionError = 0; ///< dB, of the responses.
};

/** By what each ceramic's known participations are multiplied, least squares over the modes, each in its own measure.
    @param found  N_m x N_b, as
    @param known
    @return       N_b [worker] */
Eigen::VectorXd scalesOf (const Eigen::MatrixXd& found, const Eigen::MatrixXd& known);

/** All poles and participations and the common delay at once, with shapes as they are known, by steps of Gauss and
    Newton on the posterior density within bounds, with a factor of each ceramic from a first pass. Participations are
    eliminated in each step, ceramic by ceramic; modes outside the band are powers of frequency, free at each point and
    reference.
    @param start  poles near to the most probable ones, participations, and shapes
    @param delay  s, near to the most probable one
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 8.7. */
KnownModeFit fitKnownModes (PreparedResponses&, const KnownModes& start, const KnownModePrior&, double delay);
} // namespace antinode
