#pragma once

#include "DetuningSpread.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>

namespace antinode
{
/** A device whose modes differ from the given ones by normally distributed relative errors, each mode's frequency and
   damping and each participation by its own, and all frequencies by one drift. The same seed gives the same device on
   any machine. Damping stays between 0 and 1 and frequencies positive; modes keep their order even where frequencies
   cross. [worker] Docs/Theory.md, section 7. */
ModalModel detuned (const ModalModel&, const DetuningSpread&, std::uint64_t seed);

/** The seed of one of many devices: those of neighbouring seeds and numbers have nothing in common. A plan of cases and
    a tolerance study with the same seed draw the same devices. [any] */
std::uint64_t drawSeed (std::uint64_t seed, std::uint64_t number);

/** Frequencies, damping and participations alone, which detuning changes: cheap to copy. [any] */
ModalModel withoutShapes (const ModalModel&);
} // namespace antinode
