#pragma once

#include "DeviceDescription.h"

#include <limits>

namespace antinode
{
/** The mass and stiffness of a beam's cross-section. Docs/Theory.md, sections 1.1 and 1.3. */
struct BeamSection
{
    double massPerLength = 0;                                        ///< mu, kg/m
    double bendingStiffness = 0;                                     ///< EI about the neutral axis, N m^2
    double axialStiffness = 0;                                       ///< EA, N
    double shearStiffness = std::numeric_limits<double>::infinity(); ///< S, N: of the thin theory infinite.
    double rotaryInertia = 0; ///< I about the neutral axis, kg m: of the thin theory none.
};

/** The bare substrate. @param width  of the beam, m. [any] */
BeamSection bareSection (const StructureCommon&, double width);

/** The substrate with a ceramic, or a pair of them, of its own width. Young's moduli, since a beam is free to contract
   across. A ceramic on one side couples bending to stretching. About the neutral axis the two part where no force acts
   along the beam, which holds for a beam and closely for the top of a staple on its soft legs.
    @param width  of the beam, m. [any] Docs/Theory.md, section 1.1. */
BeamSection ceramicSection (const StructureCommon&, double width, const CeramicDescription&);

/** The same where the bond hands nothing over: beside the ends that a bond needs. [any] Docs/Theory.md, section 1.16.
 */
BeamSection looseSection (const StructureCommon&, double width, const CeramicDescription&);

/** How long the bond needs at either end of a ceramic to hand its force over, m; 0 where it does not shear. A ceramic
    that is shorter by that at both ends, with a rigid bond, bends the beam as much. [any] Docs/Theory.md, section 1.16.
 */
double bondLength (const StructureCommon&, double width, const CeramicDescription&);

/** The active bending moment of a ceramic, or a pair of them, per volt, kappa_b in N m / V, with its polarity and the
   sign of d31: a section that is loaded by nothing else bends as EI w'' = kappa_b U. One ceramic alone sees the whole
   voltage whatever its wiring. @param width  of the beam, m. [any] Docs/Theory.md, sections 1.1 and 1.4; paper (23). */
double momentPerVolt (const StructureCommon&, double width, const CeramicDescription&);
} // namespace antinode
