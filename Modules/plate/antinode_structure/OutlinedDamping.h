#pragma once

#include "OutlinedGrid.h"

namespace antinode
{
/** What the losses of supports add to the damping ratio of each mode: half the loss factor times their share of its
   energy, and of dashpots c phi^2 / (2 omega). N_m
    @param shapes  of the modes at the points of the grid, in units of the problem
    [worker] Docs/Theory.md, section 1.13. */
Eigen::VectorXd dampingOfSupports (const OutlinedPlate&, const OutlinedSolution&, const OutlinedGrid&,
                                   const Eigen::MatrixXd& shapes);
} // namespace antinode
