#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** Bending waves on the thin bare plate have the angular frequency k^2 times this, m^2/s; the geometric mean of both
    directions. [any] */
double thinWaveFactor (const StructureCommon&);

/** The frequency of bending waves on a bare plate after Mindlin, with shear and rotary inertia, rad/s. On a simply
    supported plate, whose modes have the wave numbers of thin-plate theory, it is exact within his theory.
    @param waveNumber  rad/m
    [any] Mindlin, J. Appl. Mech. 18 (1951) 31-38; Docs/Theory.md, section 1.7. */
double mindlinFrequencyAt (const StructureCommon&, double waveNumber);
} // namespace antinode
