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
} // namespace antinode
