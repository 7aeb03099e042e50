#pragma once

#include "BendingProblem.h"
#include "ImmersedSpace.h"

#include <antinode_numerics/SplineAxis.h>

#include <vector>

namespace antinode
{
/** How finely a plate is resolved. Docs/Theory.md, section 1.13. */
struct ImmersedResolution
{
    int degree = 5;           ///< Of the splines.
    double cell = 0;          ///< Cells are at most so large, in the units of the outline.
    double offset = 0;        ///< How far the first line lies before the plate, in cells.
    double cornerCell = 1e-2; ///< Cells at a re-entrant corner, in units of the largest.
    double holeCell = 0.3;    ///< Cells at a hole, in units of its radius; 0.3 of it where its edge is held.
    double patchCell = 0.08;  ///< Cells on a patch whose edges bend the plate, in units of its width.
    double bendCell = 0.05;   ///< Half of the first cell at a patch's edge along an axis, in units of the largest.
};

/** What a number of modes is to be right to. */
enum class ModeAccuracy
{
    coarse, ///< Some percent, in a small part of the time: for what is being drawn.
    usual,  ///< 1e-4 of each frequency, mostly much less.
    high    ///< 1e-5.
};

/** [any] */
ImmersedResolution resolutionFor (const BendingProblem&, int count, ModeAccuracy);

/** A wave number that a number of modes hardly exceeds: Weyl's law with its term for the edges. [any] Docs/Theory.md,
 * section 1.6. */
double expectedWaveNumber (const BendingProblem&, int count);

/** The lowest modes of a plate. */
struct BendingModes
{
    ImmersedSpace space;
    Eigen::VectorXd eigenvalues;   ///< omega^2 of the flexible modes, ascending.
    Eigen::MatrixXd coefficients;  ///< unknowns x modes, mass-normalised.
    Eigen::MatrixXd participation; ///< modes x patches: integral moment . (w,11 w,22 2 w,12).
    int rigidBodyModes = 0;        ///< Motions that nothing holds, left out: 0 to 3.
};

/** The flexible modes of a plate, none missing and none false: rigid motions are known exactly, and the number of the
   others is proven by inertia.
    @param count  how many
    @throws InputError  where it cannot be solved, saying why
    [worker] Docs/Theory.md, section 1.13. */
BendingModes bendingModes (const BendingProblem&, int count, const ImmersedResolution&);

/** A place along an axis near which cells are small. */
struct SmallCells
{
    double place = 0;
    double cell = 0;      ///< The size of cells at the place.
    double growth = 1;    ///< Cells may be larger by this times the distance from it.
    int multiplicity = 0; ///< Of the knot there: 0 if there need not be a break; more than 1 lets derivatives jump.
};

/** Breaks from a place to another one, at most a cell apart and closer where that is wanted: evenly spaced by the
   integral of 1 / size. [worker] */
SplineBreaks breaksBetween (double from, double to, double cell, const std::vector<SmallCells>&);

/** Where along either axis cells are smaller than elsewhere. */
struct SmallCellsOfAxes
{
    std::vector<SmallCells> alongX, alongY;
};

/** Of what a plate has: re-entrant corners, at which moments are unbounded; arcs and holes with small radii; points
   with springs or masses; the edges of patches that bend the plate. [worker] Docs/Theory.md, section 1.13. */
SmallCellsOfAxes smallCells (const BendingProblem&, const ImmersedResolution&);
} // namespace antinode
