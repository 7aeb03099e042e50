#pragma once

#include "KnownModes.h"
#include "PreparedResponses.h"

namespace antinode
{
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
} // namespace antinode
