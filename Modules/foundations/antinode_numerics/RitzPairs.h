#pragma once

#include "BlockLanczos.h"

#include <optional>

namespace antinode
{
/** Pairs of K x = lambda M x that stand behind modes: Ritz's in the space of what the modes leave of some columns, so
   that both together span these.
    @param stiffness, mass  K and M times columns
    @param modes            orthonormal in M
    @return                 as many as columns; nothing where they depend on the modes or on each other within rounding
    [worker] Docs/Theory.md, section 1.8. */
std::optional<Eigenpairs> ritzPairsBehind (const MassProduct& stiffness, const MassProduct& mass,
                                           const Eigen::MatrixXd& modes, Eigen::MatrixXd columns);
} // namespace antinode
