#pragma once

#include "BlockBandedMatrix.h"

#include <functional>
#include <optional>

namespace antinode
{
/** M times columns. */
using MassProduct = std::function<Eigen::MatrixXd (const Eigen::MatrixXd&)>;

/** Some eigenpairs of K x = lambda M x at the lower end. */
struct Eigenpairs
{
    Eigen::VectorXd values;   ///< lambda, ascending.
    Eigen::MatrixXd vectors;  ///< One a column, orthonormal in M.
    bool areConverged = true; ///< Whether all residuals are below 1e-7 of the eigenvalue of the shifted inverse.
};

/** The lowest eigenpairs by block Lanczos on the shifted inverse, every block orthogonalised twice against all before
   it. Not even so many copies of an eigenvalue as a block has columns are missed; whether any is can be proven by
   inertia (BlockBandedFactor::negativePivots). The start is always the same, so the result is reproducible to the bit.
    Ericsson, Ruhe, Math. Comp. 35 (1980) 1251-1268; Grimes, Lewis, Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228-272.
    @param factor  of K - shift M; of an indefinite one the pairs nearest above the shift are those that are given
    @param mass    M times columns
    @param count   how many, at most the unknowns
    @return        look at areConverged: the space is limited to 6 times the count and 80 vectors
    @throws std::runtime_error  when there are no such pairs within rounding
    [worker] Docs/Theory.md, section 1.6. */
Eigenpairs lowestEigenpairs (const BlockBandedFactor& factor, const MassProduct& mass, Eigen::Index unknowns,
                             double shift, Eigen::Index count);

/** Pairs of K x = lambda M x that stand behind modes: Ritz's in the space of what the modes leave of some columns, so
   that both together span these.
    @param stiffness, mass  K and M times columns
    @param modes            orthonormal in M
    @return                 as many as columns; nothing where they depend on the modes or on each other within rounding
    [worker] Docs/Theory.md, section 1.8. */
std::optional<Eigenpairs> ritzPairsBehind (const MassProduct& stiffness, const MassProduct& mass,
                                           const Eigen::MatrixXd& modes, Eigen::MatrixXd columns);
} // namespace antinode
