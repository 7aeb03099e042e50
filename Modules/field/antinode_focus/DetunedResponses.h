#pragma once

#include "DetuningSpread.h"
#include "RowOrigin.h"

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** The responses of modes at the focus to each drive on deviating devices: rows, each weighted by the root of its
   share, whose squares, summed, are expected squares over errors of frequency and damping. */
struct DetunedResponses
{
    std::vector<int> modes;              ///< Controlled ones, then guards.
    std::vector<Eigen::MatrixXd> values; ///< Of each mode, rows x drives: the velocity per unit participation.
    /** Of each mode, rows x drives: its error. Of a controlled mode that is the difference from the nominal device,
        whose velocity is met; of a guard it is all. */
    std::vector<Eigen::MatrixXd> errors;
};

/** By the product of two Gauss-Hermite rules of three points, for frequency and damping: exact where responses are
   polynomials of degree 2 in either. [worker] Docs/Theory.md, section 7.5. */
DetunedResponses detunedResponses (const ModalModel&, const RowOrigin&, const DetuningSpread&);
} // namespace antinode
