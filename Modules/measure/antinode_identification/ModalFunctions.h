#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The contributions of a mode of given pole, as functions of frequency: the mode itself and its derivatives.
    Mode k has the columns from functions k on, in this order; powers of i omega follow after all modes. */
enum class ModalFunction
{
    velocity,       ///< g = i omega / D, D = omega_k^2 - omega^2 + 2 i xi omega_k omega; times omega_k.
    frequency,      ///< dg/domega_k xi omega_k, times omega_k: a shift by the half width.
    damping,        ///< dg/dxi xi, times omega_k: a relative change of the damping.
    delay,          ///< -i omega g = omega^2 / D: a delay, behind unit mode.
    delayFrequency, ///< As frequency and damping, of the function delay: only where residues are complex.
    delayDamping
};

/** The number of functions in a fit: real residues need four, complex ones all. */
constexpr Eigen::Index realModeFunctions = 4, complexModeFunctions = 6;

/** The poles and powers of a fit. N_m modes. */
struct ModalBasis
{
    Eigen::VectorXd angularFrequencies;         ///< N_m: rad/s
    Eigen::VectorXd dampingRatios;              ///< N_m
    std::vector<int> powers;                    ///< Of i omega / scale.
    double scale = 1;                           ///< rad/s: keeps powers near 1.
    Eigen::Index functions = realModeFunctions; ///< Of each mode.

    Eigen::Index modes() const { return angularFrequencies.size(); }
    Eigen::Index modalColumns() const { return functions * modes(); }
    Eigen::Index size() const { return modalColumns() + static_cast<Eigen::Index> (powers.size()); }
    Eigen::Index column (Eigen::Index mode, ModalFunction function) const
    {
        return functions * mode + static_cast<Eigen::Index> (function);
    }
};

/** The functions of one mode. @param omega N lines, rad/s @return N x functions [any] Docs/Theory.md, section 8.4. */
Eigen::MatrixXcd evaluateModalFunctions (const ModalBasis&, Eigen::Index mode, const Eigen::VectorXd& omega);

/** The powers of i omega / scale. @param omega N lines, rad/s, above 0 @return N x powers [any] */
Eigen::MatrixXcd evaluatePowers (const ModalBasis&, const Eigen::VectorXd& omega);

/** How many values of a smooth function stand for all of it on some neighbouring lines. */
constexpr Eigen::Index smoothNodes = 16;

/** From how many half lengths of its lines' range on a pole leaves a function smooth: the error of its interpolation is
    (3 + sqrt 8)^-16 = 5e-13. */
constexpr double smoothDistance = 3;

/** Below so many lines nodes save nothing. */
constexpr Eigen::Index fewLines = 4 * smoothNodes;

/** Chebyshev's nodes of a range of frequencies. @return smoothNodes, rad/s, descending [any] */
Eigen::VectorXd chebyshevNodes (double centre, double halfWidth);

/** The polynomials that are 1 at one of Chebyshev's nodes and 0 at the others: what takes values at the nodes to values
    anywhere.
    @param at     N, rad/s
    @param nodes  from chebyshevNodes
    @return       N x smoothNodes
    [any] Docs/Theory.md, section 8.4. */
Eigen::MatrixXd interpolation (const Eigen::VectorXd& at, const Eigen::VectorXd& nodes);

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
