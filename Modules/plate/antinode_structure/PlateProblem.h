#pragma once

#include "CeramicBond.h"
#include "PlateSection.h"
#include "TensorOperator.h"

#include <antinode_numerics/BlockLanczos.h>
#include <antinode_numerics/SplineAxis.h>

#include <optional>
#include <vector>

namespace antinode
{
/** The rectangle of a ceramic, by the lines that bound it. */
struct PlatePatch
{
    Eigen::Index left = 0, right = 0, bottom = 0, top = 0; ///< Indices of lines.
};

/** The lines at which a plate's section changes, with lengths in units of its longer side. */
struct PlateLayout
{
    double unit = 0;                 ///< The longer side, m.
    Eigen::VectorXd linesX, linesY;  ///< The plate's edges and those of its ceramics, ascending.
    std::vector<PlatePatch> patches; ///< Of each ceramic.
};

/** Lines closer than a 5000th of the shorter side become one: so much less than the plate's waves is not seen by them,
   and cells much narrower than others cost digits. Opposite edges of one ceramic stay apart.
    @throws InputError  when a ceramic is narrower than that
    [worker] */
PlateLayout makeLayout (const PlateDescription&);

/** A ceramic as it lies between its lines. [any] */
CeramicDescription onLines (const PlateDescription&, const PlateLayout&, std::size_t ceramic);

/** The resolution of an axis. Docs/Theory.md, section 1.6. */
struct PlateResolution
{
    int degree = 5;           ///< Of the splines.
    double largestCell = 0.1; ///< In units of the longer side.
    int layers = 2;           ///< Cells that shrink towards every line, on either side.
    double layerRatio = 0.25; ///< By which each is smaller than the one before.
};

/** The splines' breaks between the lines of one axis: cells of equal size in each segment, smaller towards its ends.
   Bending moments may jump on the lines, so only the slope is continuous there; the axis' ends are held as the plate's
   edges are. [worker] */
SplineBreaks divide (const Eigen::VectorXd& lines, const PlateResolution&, EdgeCondition start, EdgeCondition end);

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
