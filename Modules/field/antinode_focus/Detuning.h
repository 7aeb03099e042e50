#pragma once

#include <antinode_model/ModalModel.h>

#include <cstdint>

namespace antinode
{
/** Relative standard deviations of a real device from its model. Docs/Theory.md, section 7. */
struct DetuningSpread
{
    double frequency = 0;     ///< Of each mode's frequency.
    double damping = 0;       ///< Of each mode's damping.
    double participation = 0; ///< Of each participation.
    double drift = 0;         ///< Of a factor that all frequencies share, as with temperature.
};

/** The remaining spread of a device after its modes have been measured and adopted. */
inline constexpr DetuningSpread usualSpread { 0.001, 0.1, 0.05, 0 };

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
