#pragma once

#include "DeviceDescription.h"

#include <limits>
#include <optional>
#include <vector>

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

/** A straight stretch of one cross-section. */
struct ChainElement
{
    double start = 0, length = 0; ///< m; start counts along its member, on the surface it is the surface's x.
    double cosine = 1, sine = 0;  ///< Its direction, from its first to its last end.
    BeamSection section;
    bool onSurface = true;      ///< Whether it is part of what is touched.
    std::optional<int> ceramic; ///< The ceramic that covers it.
};

/** The restrained motions of an end of a chain. */
struct Restraint
{
    bool alongX = false, alongY = false, rotation = false;
};

/** A body made of elements one after the other, rigidly joined: a beam, or the members of a frame. */
struct ElementChain
{
    std::vector<ChainElement> elements;
    Restraint start, end;
    bool stretches = false; ///< Whether elements stretch as well as bend. Where not, nothing moves along x.
    bool shears = false;    ///< Whether they shear, and their sections have inertia against turning.
};

/** Refuses a device whose numbers overflow or are negligible relative to each other. @throws InputError [any] */
[[noreturn]] void throwNumbersTooFarApart();

/** Wave number of bending waves in 1/m: (omega^2 mu / EI)^(1/4), and more where sections shear. [any] Docs/Theory.md,
    section 1.3. */
double bendingWaveNumber (const BeamSection&, double angularFrequency);

/** About the angular frequency, rad/s, below which a chain has so many bending modes: that at which so many half waves
    fit into it. [any] */
double angularFrequencyOfHalfWaves (const ElementChain&, double halfWaves);

/** The inverse of angularFrequencyOfHalfWaves(). [any] */
double halfWavesAt (const ElementChain&, double angularFrequency);

/** The chain with its elements cut into equal parts so short that none exceeds 0.38 of a bending wave. On such parts
   polynomials of degree 8 hold frequencies to about 1e-10 and shapes to 1e-7.
    @throws InputError  where a wave's length is beyond all numbers. [any] */
ElementChain subdivided (const ElementChain&, double angularFrequency);

/** A described beam as a chain of its bare and covered stretches, from left to right. [any] Docs/Theory.md,
    section 1.3. */
ElementChain makeChain (const BeamDescription&);

/** A described staple as a chain: the left leg upwards, the top from left to right, the right leg downwards.
    [any] Docs/Theory.md, section 1.3. */
ElementChain makeChain (const StapleDescription&);
} // namespace antinode
