#pragma once

#include "Immersed/BendingExamples.h"

namespace antinode::scores
{
/** The worst of random plates. */
struct OutlineScore
{
    const char* what = "";
    int cases = 0;
    double frequencyError = 0;     ///< Relative.
    double participationError = 0; ///< Of the largest one of the plate.
    double seconds = 0;            ///< Processor time of the slowest.
    std::string worst {};          ///< The parameters of the plate with the largest error of a frequency.
};

/** Circles and rings, free, supported, clamped and on springs, fifty modes, against Bessel's determinants. */
OutlineScore roundPlates (int cases, unsigned seed, ModeAccuracy);

/** Rounded rectangles with a hole, shifted and turned against the cells, thirty modes, against the same unturned.
   Throws where a rigid motion is missing. */
OutlineScore shiftedAndTurned (int cases, unsigned seed);

/** A disc of a ceramic amid a circle anywhere on the cells, fifty modes, against Bessel's determinants. */
OutlineScore plateaus (int cases, unsigned seed);

/** A square of a ceramic at any angle and place, twenty modes, against smaller cells. */
OutlineScore turnedSquares (int cases, unsigned seed);

/** L and notches of random proportions, free and clamped, twelve modes, against smaller cells. */
OutlineScore reentrantCorners (int cases, unsigned seed);

/** Rectangles with two sides supported and two on springs, twenty modes, against Levy's solution. */
OutlineScore levyPlates (int cases, unsigned seed);

/** Masses or springs at random points of a supported rectangle, against their secular equation. */
OutlineScore attachedPoints (int cases, unsigned seed);

/** Eight discs or turned squares on a rounded rectangle, fifty modes, against smaller cells. */
OutlineScore eightPatches (unsigned seed, bool areDiscs);
} // namespace antinode::scores
