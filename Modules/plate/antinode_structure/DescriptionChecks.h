#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** Two edges closer than this are the same edge, m: rounding, not geometry. */
constexpr double edgeTolerance = 1e-9;

/** The name of a ceramic in errors, for example "ceramic 3 (C3)". [any] */
std::string ceramicPlace (std::size_t index, const CeramicDescription&);

/** Checks a beam's dimensions, substrate, damping, limits and ceramics.
    @throws InputError  naming the first thing that is wrong, and what is allowed. [worker] */
void requireSolvable (const BeamDescription&);

/** The same for a staple, whose ceramics lie on its top. [worker] */
void requireSolvable (const StapleDescription&);
/** The same for a plate: its material, edges and ceramics in the plane. [worker] */
void requireSolvable (const PlateDescription&);

/** The same for an outlined plate: also its outline, supports, and ceramics on it and apart. [worker] */
void requireSolvable (const OutlinedPlate&);
} // namespace antinode
