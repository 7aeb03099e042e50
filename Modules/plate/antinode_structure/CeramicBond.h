#pragma once

#include "PlateSection.h"

#include "BendingProblem.h"

#include <optional>

namespace antinode
{
/** A ceramic on a plate whose bond shears: its own bending goes with the plate everywhere, what it does by stretching
    builds up from its edges. */
struct CeramicBond
{
    LayeredSection loose; ///< The section without what the bond hands over.
    BondedPart part;      ///< What it hands over, in SI.
};

/** The compliance in shear between the face of a plate and the middle of what is glued to it, m/Pa: the glue's, and in
    Mindlin's theory that of the ceramic. [any] Docs/Theory.md, section 1.16. */
double bondCompliance (const CeramicDescription&, BendingTheory, bool withCeramic = true);

/** How much longer the build-up is where the plate yields than where its curvature is given.
    @param stiffening  bending stiffness with the whole bond over that without it, above 1
    [any] Docs/Theory.md, section 1.16. */
double yieldingFactor (double stiffening);

/** The bond of a ceramic; nothing where nothing shears.
    @param angle        of the ceramic, rad counter-clockwise
    @param withCeramic  false: of a bender's disc without it
    [any] Docs/Theory.md, section 1.16. */
std::optional<CeramicBond> ceramicBond (const StructureCommon&, const CeramicDescription&, double angle,
                                        bool withCeramic = true);

/** The inertia against turning, per area, that a ceramic adds in Mindlin's theory, kg; 0 in that of thin plates. [any]
 */
double addedRotaryInertia (const StructureCommon&, const CeramicDescription&, bool withCeramic = true);
} // namespace antinode
