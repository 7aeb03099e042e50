#pragma once

#include "KnownModes.h"
#include "NormalModes.h"
#include "PreparedResponses.h"

#include <vector>

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

/** Known modes at one place of the search for the most probable ones. N_m modes, C columns. */
struct KnownModeState
{
    ModalBasis basis;
    ModalProducts reduced;               ///< With the powers taken out.
    Eigen::MatrixXd errors;              ///< functions x C: products of all functions with what is left of the data.
    Eigen::MatrixXd coefficients;        ///< (functions and powers) x C: of the fit.
    std::vector<Eigen::MatrixXd> shapes; ///< N_b of N_m x N_m: products of shapes over the points, weighted.
    Eigen::MatrixXd weightedShapes;      ///< N_m x C: shapes of the modes at each column, weighted.
    double values = 0;                   ///< How many were measured.
    double variance = 0;                 ///< Of each value, times its weight: what is left.
    double reconstructionError = 0;      ///< dB
    Eigen::VectorXd pointErrors;         ///< N_p: what is left of each point's responses, RMS over RMS.
};

/** @param moments  near to the delay [worker] */
KnownModeState knownModeState (const PreparedResponses&, const LineMoments& moments, const KnownModes&, double delay);

/** participation over angular frequency, N_m x N_b: the coefficients of the function velocity, per shape. [any] */
Eigen::MatrixXd strengthsOf (const KnownModes&);

/** The rows or columns of one function of all modes. [any] */
inline auto functionsOf (ModalFunction function, Eigen::Index modes)
{
    return Eigen::seqN (static_cast<Eigen::Index> (function), modes, Eigen::fix<realModeFunctions>);
}

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
