#pragma once

#include "PreparedResponses.h"

namespace antinode
{
/** Responses of one band, as few outputs and few references that hold nearly all of their energy. N lines. */
struct CompressedBand
{
    Eigen::VectorXd omega;                ///< N: rad/s
    std::vector<Eigen::MatrixXcd> values; ///< One a reference, N x outputs.

    Eigen::Index lines() const { return omega.size(); }
    Eigen::Index outputs() const { return values.front().cols(); }
    Eigen::Index references() const { return static_cast<Eigen::Index> (values.size()); }
};

/** Projects the lines of a band on the strongest real directions of points and of references: noise outside of them is
   gone, and real modes stay real. Weights of points and references are in the values.
    @param first, count   lines
    @param outputs, references  the largest numbers
    [worker] Docs/Theory.md, section 8.2. */
CompressedBand compress (const PreparedResponses&, Eigen::Index first, Eigen::Index count, Eigen::Index outputs,
                         Eigen::Index references);
} // namespace antinode
