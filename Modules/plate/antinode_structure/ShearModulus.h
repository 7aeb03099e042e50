#pragma once

#include "MaterialTypes.h"

#include <complex>

namespace antinode
{
/** The complex shear modulus of a viscoelastic material, Pa: real part and real part times loss factor. Between rows of
   a table the modulus is interpolated as a power of frequency, the loss factor over its logarithm; beyond its ends the
   table holds.
    @param angularFrequency  rad/s, above 0
    [any] Docs/Theory.md, section 1.15. */
std::complex<double> shearModulusAt (const ViscoelasticMaterial&, double angularFrequency);
} // namespace antinode
