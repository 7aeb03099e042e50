#pragma once

#include "BeamSection.h"

#include <optional>
#include <vector>

namespace antinode
{
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
} // namespace antinode
