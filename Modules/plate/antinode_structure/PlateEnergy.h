#pragma once

#include "PlateProblem.h"

namespace antinode
{
/** Twice the strain energy of pairs of fields, by quadrature of their curvatures. The stiffness operator loses digits
   to cancellation if cells are small relative to the plate; here there is no cancellation.
    @param fields  unknowns x N
    @return        N x N, in the units of the problem
    [worker] Docs/Theory.md, section 1.6. */
Eigen::MatrixXd strainEnergies (const PlateDescription&, const PlateLayout&, const PlateProblem&,
                                const Eigen::MatrixXd& fields);

/** The rounding in the stiffness operator relative to 1, in units of eigenvalues: a lower estimate of their error.
    [any] */
double stiffnessRounding (const PlateProblem&);
} // namespace antinode
