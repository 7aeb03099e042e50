#pragma once

#include "DeviceDescription.h"
#include "LayeredSection.h"

namespace antinode
{
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
