#pragma once

#include "ModalProducts.h"

#include <functional>

namespace antinode
{
/** Real normal modes as a fit knows them. N_m modes, N_p points, N_b references. */
struct NormalModes
{
    Eigen::VectorXd angularFrequencies; ///< N_m: rad/s
    Eigen::VectorXd dampingRatios;      ///< N_m
    Eigen::MatrixXd shapes;             ///< N_p x N_m
    Eigen::MatrixXd participation;      ///< N_m x N_b
    double delay = 0;                   ///< s

    Eigen::Index modes() const { return angularFrequencies.size(); }
};

/** The functions of modes' poles, and the powers of i omega that represent modes outside the band. */
ModalBasis makeBasis (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                      const PreparedResponses&);

/** x of a x = b for a symmetric positive matrix, made even on its diagonal first. @param ridge on that diagonal
    [worker] */
Eigen::MatrixXd solveEven (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double ridge);

/** Products with the powers fitted and taken out of data and functions; what is left are the functions of the modes.
    [worker] Docs/Theory.md, section 8.4. */
ModalProducts withoutPowers (const ModalBasis&, const ModalProducts&);

/** Residues of all modes by least squares, each reference and point on its own: complex, so that no delay need be
   known.
    @return  N_m x C: r with r / (i omega - s) + conj; times 2 j b / s they are phi alpha for real modes without delay
    [worker] Docs/Theory.md, section 8.4. */
Eigen::MatrixXcd complexResidues (const ModalBasis&, const ModalProducts&, double ridge);

/** Coefficients of the powers once the modes are known.
    @param products    with powers
    @param amplitudes  4 N_m x C: of all functions of the modes
    @return            powers x C
    [worker] */
Eigen::MatrixXd powerCoefficients (const ModalBasis&, const ModalProducts& products, const Eigen::MatrixXd& amplitudes);

/** The delay that makes residues of all modes as real as can be; the smallest where several do.
    @param residues  phi alpha times exp (-i omega_k delay), N_m x C
    [worker] Docs/Theory.md, section 8.4. */
double estimateDelay (const Eigen::VectorXd& angularFrequencies, const Eigen::MatrixXcd& residues,
                      const Eigen::VectorXd& columnWeights);

/** The delay that scores highest, from -3 to 3 ms. Among many delays a few modes agree on a wrong one by chance: a long
    one must be better than a short one.
    @param score    of a delay in s, smooth
    @param highest  rad/s, of the modes
    @param price    of a long delay, in units of the score
    @return         s; the smallest where several do
    [worker] Docs/Theory.md, section 8.4. */
double searchDelay (const std::function<double (double)>& score, double highest, double price);
} // namespace antinode
