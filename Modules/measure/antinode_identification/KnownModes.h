#pragma once

#include "PreparedResponses.h"

#include <Eigen/Core>

namespace antinode
{
/** Modes as they are known before a measurement, at its points. N_m modes, N_p points, N_b references. */
struct KnownModes
{
    Eigen::VectorXd angularFrequencies; ///< N_m: rad/s, ascending.
    Eigen::VectorXd dampingRatios;      ///< N_m
    Eigen::MatrixXd shapes;             ///< N_p x N_m: kg^-1/2
    Eigen::MatrixXd participation;      ///< N_m x N_b: N kg^-1/2 / V

    Eigen::Index modes() const { return angularFrequencies.size(); }
};

/** Standard deviations of known modes from what is measured, relative. */
struct KnownSpread
{
    double frequency = 0.02;     ///< Of each frequency.
    double damping = 0.3;        ///< Of each damping ratio.
    double participation = 0.05; ///< Of each participation, beside a factor of each ceramic.
    double drift = 0.03;         ///< Of a factor that all frequencies share.
};

/** What some lines say of each mode alone. N lines, N_m modes. */
struct ModalReceptances
{
    Eigen::VectorXd omega;      ///< N: rad/s, some of the measured lines.
    Eigen::MatrixXcd values;    ///< N x N_m: estimates of i omega / (omega_k^2 - omega^2 + 2 i xi_k omega_k omega),
                                ///< times the common delay's factor; unbiased.
    Eigen::MatrixXd precisions; ///< N x N_m: 1 / variance of each; 0 where nothing is said.
};

/** Separates modes line by line, by the products of shape and participation that all points and references see of each:
    least squares with the size that each mode may have at a line, over all places that its frequency may be at. So
    modes closer than their widths are told from each other, and no phase need be known.
    @param spreads  N_m: standard deviation of each frequency, relative
    @param delay    s, is taken out of the responses: what is left of it must turn no line against its neighbours
    @throws Cancelled  as checkWatch()
    [worker] Docs/Theory.md, section 8.7. */
ModalReceptances separateModes (const PreparedResponses&, const KnownModes&, const Eigen::VectorXd& spreads,
                                double delay);

/** Where known modes are found in a measurement. N_m modes. */
struct KnownPoles
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::VectorXd gains;                             ///< N_m: how much of the log likelihood each explains.
    double drift = 1;                                  ///< The median factor of frequencies.
    double delay = 0;                                  ///< s
};

/** The most probable pole of each mode from what lines say of it alone, at any phase and with an amplitude near 1:
   first with any common drift, then relative to it, then more precisely about what was found.
    @throws InputError  when none of the modes is seen
    [worker] Docs/Theory.md, section 8.7. */
KnownPoles findKnownPoles (const PreparedResponses&, const KnownModes&, const KnownSpread&);
} // namespace antinode
