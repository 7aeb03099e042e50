#pragma once

#include "DeviceDescription.h"
#include "Materials.h"

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

/** The bending properties of a plate's section along its axes, and the moment of a ceramic per volt. Docs/Theory.md,
   section 1.1. */
struct PlateSection
{
    double massPerArea = 0;          ///< kg/m^2
    double d11 = 0, d22 = 0;         ///< Bending stiffness along x and y, N m
    double d12 = 0;                  ///< Coupling of the two curvatures, N m
    double d66 = 0;                  ///< Twisting stiffness, N m: M12 = 2 D66 w,12 and its energy is 2 D66 w,12^2.
    double momentX = 0, momentY = 0; ///< kappa_b, N / V: moment per length and volt about either axis, with its sign.
    double rotaryInertia = 0;        ///< Per area, kg: that frequencies are not corrected for afterwards.
};

// The sections of a plate with layers, glue and carriers, soft layers at the reference of the description. [any]
// Docs/Theory.md, section 1.15.

LayeredSection bareStack (const StructureCommon&);

/** What of a ceramic is on the plate. */
struct StackParts
{
    bool withCeramic = true; ///< False: of a disc bender its disc, beside the ceramic.
    bool isBonded = true;    ///< False: no shear passes between glue and ceramic.
};

/** From the bottom up. */
std::vector<SectionLayer> plateLayers (const StructureCommon&);

/** What is glued on, along its own axes and without voltage, from the plate outwards. */
std::vector<SectionLayer> gluedLayers (const CeramicDescription&, bool withCeramic);

/** Plate, glue and what is glued on, from the bottom up. @param angle  of the ceramic, rad counter-clockwise */
std::vector<SectionLayer> stackLayers (const StructureCommon&, const CeramicDescription&, double angle,
                                       const StackParts& = {});

LayeredSection sectionWith (const StructureCommon&, const CeramicDescription&, double angle, const StackParts& = {});

PlateSection alongAxes (const LayeredSection&);

/** The bare substrate. [any] */
PlateSection bareSection (const StructureCommon&);

/** The substrate with a ceramic, or a pair of them. A ceramic on one side couples bending to stretching: what is left
   when no force acts in the plane, D - B A^-1 B, is taken, which for equal Poisson's ratios is the section about its
   shifted neutral axis. One ceramic alone sees the whole voltage whatever its wiring. [any] Docs/Theory.md,
   sections 1.1 and 1.4; paper (10), (23). */
PlateSection ceramicSection (const StructureCommon&, const CeramicDescription&);
} // namespace antinode
