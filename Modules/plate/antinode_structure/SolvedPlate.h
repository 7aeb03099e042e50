#pragma once

#include "PlateSolution.h"

namespace antinode
{
/** The number of Gauss's and Legendre's places that represent a wave of a phase, rad, over their segment to 3e-5 of its
   amplitude. [any] Docs/Theory.md, section 1.5. */
int placesForPhase (double phase, int fewest);

/** The modal model of a solved plate: frequencies, participations, and shapes on a grid of Gauss's and Legendre's
   places whose segments end where the section changes, so that weights are exact and polynomials give the shapes in
   between: as many places as a 3e-5th of a wave's amplitude takes at the highest mode. Each shape is positive where it
   first exceeds a tenth of its largest amplitude, point by point; modes of one frequency are those whose motion is most
   and least spread along x.
    @return  without names, damping, limits
    [worker] Docs/Theory.md, sections 1.4 to 1.6; paper (23). */
ModalModel makeModel (const PlateDescription&, const PlateSolution&);

/** Fields of splines on the points of a grid.
    @param unit          of length, m
    @param coefficients  unknowns x N
    @return              N_p x N
    [worker] */
Eigen::MatrixXd shapesOn (const PlateGrid&, const PlateProblem&, double unit, const Eigen::MatrixXd& coefficients);

/** The thin plate of one section that is solved in place of a plate. [any] Docs/Theory.md, section 1.15. */
PlateDescription asSolved (const PlateDescription&, std::optional<int> modeCount);

/** A plate, solved and put on a grid. @throws InputError [worker] */
ModalModel solvePlate (const std::string& name, const PlateDescription&, std::optional<int> modeCount);
} // namespace antinode
