#pragma once

#include "MaterialTypes.h"

#include <complex>

namespace antinode
{
/** One layer of a section, bonded to its neighbours. */
struct SectionLayer
{
    double thickness = 0;                                    ///< m
    double density = 0;                                      ///< kg/m^3
    Eigen::Matrix3cd stiffness = Eigen::Matrix3cd::Zero();   ///< Stress (11, 22, 12) by strain (11, 22, 2 12), Pa.
    Eigen::Vector3d stressPerVolt = Eigen::Vector3d::Zero(); ///< Of a piezoelectric one, with its sign, Pa/V.
    std::optional<std::complex<double>> softShearModulus {}; ///< Of a soft one, Pa: between others it only shears.
};

/** What a section does in bending: moments (M11, M22, M12) = stiffness (w,11 w,22 2 w,12), complex with soft layers. */
struct LayeredSection
{
    Eigen::Matrix3cd stiffness;     ///< N m
    Eigen::Vector3cd momentPerVolt; ///< N/V
    double massPerArea = 0;         ///< kg/m^2

    /** The imaginary part of the stiffness over its real part, along x. */
    double lossFactor() const { return stiffness (0, 0).imag() / stiffness (0, 0).real(); }
};

/** The bending stiffness of a stack of layers that no force in the plane holds. Layers between two soft ones are a face
   that bends about its own neutral axis, D - B A^-1 B; what soft layers shear lets faces move against each other, the
   less the longer the waves. Without soft layers between others the wave number does not count.
    @param layers      from the bottom up, at least one that is not soft
    @param waveNumber  rad/m, above 0
    [any] Docs/Theory.md, sections 1.1 and 1.15. */
LayeredSection layeredSection (const std::vector<SectionLayer>& layers, double waveNumber);

// Layers of a material. [any]

SectionLayer elasticLayer (const ElasticMaterial&, double thickness);

/** @param angularFrequency  at which its modulus is taken, rad/s */
SectionLayer softLayer (const ViscoelasticMaterial&, double thickness, double angularFrequency);

/** @param voltage  of one volt at the terminals what this layer sees, V: with its sign by polarity and place
    @param angle    of the fibres of a composite, rad counter-clockwise from x */
SectionLayer piezoelectricLayer (const PiezoelectricMaterial&, double thickness, double voltage, double angle);
} // namespace antinode
