#pragma once

#include "PlateProblem.h"

namespace antinode
{
/** Twice the strain energy of pairs of fields, by quadrature of their curvatures. The stiffness operator loses digits to cancellation
    where cells are small beside the plate; here none of that is left.
    @param fields  unknowns x N
    @return        N x N, in the units of the problem
    [worker] Docs/Theory.md, section 1.6. */
Eigen::MatrixXd strainEnergies (const PlateDescription&, const PlateLayout&, const PlateProblem&,
                                const Eigen::MatrixXd& fields);

/** How large rounding in the stiffness operator is beside 1, in units of eigenvalues: a lower estimate of their error. [any] */
double stiffnessRounding (const PlateProblem&);
} // namespace antinode
