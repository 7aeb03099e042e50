#pragma once

#include "DeviceDescription.h"

#include <complex>

namespace antinode
{
/** Whether a laminate has a layer whose modulus depends on frequency. [any] */
bool hasSoftLayers (const StructureCommon&);

/** The bending stiffness of the bare plate, the geometric mean of both directions, N m; its phase is the loss.
    @param waveNumber        rad/m
    @param angularFrequency  at which soft layers are taken, rad/s
    [any] */
std::complex<double> stiffnessAt (const StructureCommon&, double waveNumber, double angularFrequency);

/** The frequency of bending waves on a bare plate with soft layers, rad/s, and their loss factor. */
struct LossyFrequency
{
    double angularFrequency = 0; ///< The root of the real part of omega^2.
    double lossFactor = 0;       ///< The imaginary part of omega^2 over the real one.
};

/** omega^2 = k^4 D (k, omega) / m, which on a simply supported sandwich is exact. [any] Mead and Markus, J. Sound Vib.
    10 (1969) 163; Docs/Theory.md, section 1.15. */
LossyFrequency lossyFrequencyAt (const StructureCommon&, double waveNumber);
} // namespace antinode
