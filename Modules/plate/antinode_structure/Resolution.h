#pragma once

#include "BendingProblem.h"

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
};

/** What a number of modes is to be right to. */
enum class ModeAccuracy
{
    usual, ///< 1e-4 of each frequency, mostly much less.
    high   ///< 1e-5.
};

/** [any] */
ImmersedResolution resolutionFor (const BendingProblem&, int count, ModeAccuracy);

/** A wave number that a number of modes hardly exceeds: Weyl's law with its term for the edges. [any] Docs/Theory.md,
 * section 1.6. */
double expectedWaveNumber (const BendingProblem&, int count);
} // namespace antinode
