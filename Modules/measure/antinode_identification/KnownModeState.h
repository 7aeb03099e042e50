#pragma once

#include "KnownModes.h"
#include "NormalModes.h"

#include <vector>

namespace antinode
{
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
} // namespace antinode
