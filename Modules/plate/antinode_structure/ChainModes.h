#pragma once

#include "ChainBasis.h"

namespace antinode
{
/** The flexible modes of a chain, ascending, to twice the frequency that it was divided for. */
struct ChainModes
{
    Eigen::VectorXd angularFrequencies; ///< rad/s
    Eigen::MatrixXd coefficients;       ///< Of the chain's basis, unknowns x modes: integral m phi_k phi_l = delta_kl.
    int rigidBodyModes = 0;
};

/** The modes of a chain that is divided finely enough for the given frequency.
    @param degree            of the transverse displacement on each element
    @param angularFrequency  the highest that is wanted, rad/s
    @throws InputError       where numbers overflow or too many unknowns would be needed
    [worker] Docs/Theory.md, section 1.3. */
ChainModes solveChain (const ElementChain&, int degree, double angularFrequency);
} // namespace antinode
