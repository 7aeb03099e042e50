#pragma once

#include "PlateProblem.h"

#include <optional>

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

/** A plate with the lowest of its modes as coefficients of splines. */
struct PlateSolution
{
    PlateLayout layout;
    PlateProblem problem;
    int rigidBodyModes = 0;
    Eigen::VectorXd angularFrequencies; ///< Of the flexible modes, rad/s, ascending.
    Eigen::MatrixXd coefficients;       ///< Unknowns x flexible modes, mass-normalised in SI: kg^-1/2.
    Eigen::VectorXd frequencyErrors;    ///< Estimated from splines of one degree less, relative.
    double waveNumber = 0;              ///< Of the shortest waves anywhere at the highest mode, rad/m.
};

/** Solves for the given number of flexible modes, for those that the description asks for, or for 100.
    Modes of equal frequency are distinguished by where they move most along x, and every mode is positive where it
   first exceeds a tenth of its largest amplitude (that is done when it is put on a grid).
    @throws InputError  when the plate cannot be solved, saying why
    [worker] Docs/Theory.md, section 1.6. */
PlateSolution solvePlateModes (const PlateDescription&, std::optional<int> modeCount);

/** The load of one volt on a rectangular ceramic on each spline: kappa_x integral B,xx + kappa_y integral B,yy, and
   what its bond hands over. Times the coefficients of a shape it is this shape's participation.
    @param unit  the plate's longer side, m
    @return      one value an unknown
    [worker] Docs/Theory.md, sections 1.4 and 1.16; paper (23). */
Eigen::VectorXd ceramicLoad (const PlateProblem&, const StructureCommon&, const CeramicDescription&, double unit);
} // namespace antinode
