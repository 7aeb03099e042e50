#pragma once

#include "CeramicBond.h"
#include "PlateLayout.h"
#include "TensorOperator.h"

#include <antinode_numerics/BlockLanczos.h>

#include <optional>

namespace antinode
{
/** A plate's stiffness and mass on tensor products of splines: lengths in units of the longer side, stiffness and mass
   in those of the bare substrate. The axis with more cells is the outer one, so that blocks stay small. */
struct PlateProblem
{
    SplineAxis outer, inner;
    bool outerIsX = true;
    TensorOperator stiffness, mass;

    Eigen::Index unknowns() const { return outer.size() * inner.size(); }
    const SplineAxis& x() const { return outerIsX ? outer : inner; }
    const SplineAxis& y() const { return outerIsX ? inner : outer; }

    /** A field's coefficients as a matrix, splines of x by splines of y. [any] */
    Eigen::MatrixXd coefficients (const Eigen::VectorXd& field) const;

    /** The reverse of it. [any] */
    Eigen::VectorXd field (const Eigen::MatrixXd& coefficients) const;
};

/** A part of a plate, from cell to cell of its axes, and what it adds. */
struct PlateRegion
{
    Eigen::Index beginX = 0, endX = 0, beginY = 0, endY = 0;
    PlateSection section;             ///< In units of the bare substrate's stiffness and mass, and of the longer side.
    std::optional<BondedPart> bonded; ///< What adds to it, in the same units.
};

/** The whole plate as if it were bare, and each ceramic as what it adds to that. [worker] */
std::vector<PlateRegion> makeRegions (const PlateDescription&, const PlateLayout&, const SplineAxis& x,
                                      const SplineAxis& y);

/** [worker] Docs/Theory.md, section 1.6. */
PlateProblem plateProblem (const PlateDescription&, const PlateLayout&, const PlateResolution&);

/** The same on given axes, in units of the longer side. [worker] */
PlateProblem plateProblem (const PlateDescription&, const PlateLayout&, const SplineAxis& x, const SplineAxis& y);

/** The number of unknowns it would have; the largest number if they cannot be counted. [worker] */
Eigen::Index expectedUnknowns (const PlateDescription&, const PlateLayout&, const PlateResolution&);

/** The mass operator between the splines of two problems of one plate with the same breaks: integral m u v, u of `rows`
   and v of `columns`. [worker] */
TensorOperator massBetween (const PlateDescription&, const PlateLayout&, const PlateProblem& rows,
                            const PlateProblem& columns);

/** The lowest eigenpairs, rigid-body motions included; that none is missed is proven by inertia.
    @throws InputError  when the plate's numbers lie too far apart to solve it, or there are not so many unknowns
    [worker] Docs/Theory.md, section 1.6. */
Eigenpairs solve (const PlateProblem&, Eigen::Index count);

/** The number of eigenvalues below a value; nothing if the value is too close to one. [worker] */
std::optional<Eigen::Index> eigenvaluesBelow (const PlateProblem&, double value);
} // namespace antinode
