#pragma once

#include "ModalFunctions.h"

namespace antinode
{
/** The number of lines processed at once. */
constexpr Eigen::Index linesOfSegment = 512;

/** All functions of a basis on neighbouring lines. Those of modes far from them are smooth there: they are interpolated
   from Chebyshev's nodes, so that work grows with the modes near a line, not with all. Docs/Theory.md, section 8.4. */
struct LineSegment
{
    std::vector<Eigen::Index> near, far;     ///< Columns of the basis.
    Eigen::MatrixXd nearReal, nearImaginary; ///< Lines x near.
    Eigen::MatrixXd interpolation;           ///< Lines x nodes; empty if nothing is far.
    Eigen::MatrixXd farReal, farImaginary;   ///< Nodes x far: values at the nodes.
};

/** @param omega  lines, rad/s [worker] */
LineSegment lineSegment (const ModalBasis&, const Eigen::VectorXd& omega);
} // namespace antinode
