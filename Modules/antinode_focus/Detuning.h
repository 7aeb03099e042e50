#pragma once

#include <antinode_model/ModalModel.h>

#include <cstdint>

namespace antinode
{
/** Standard deviations, relative, of what a real device differs by from its model. */
struct DetuningSpread
{
    double frequency = 0;
    double damping = 0;
    double participation = 0;
};

/** A device whose modes differ from the given ones by normally distributed relative errors, each mode's frequency and damping and
    each participation by its own. The same seed gives the same device on any machine. Damping stays between 0 and 1 and frequencies
    positive; modes keep their order even where frequencies cross.
    [worker] Docs/Theory.md, section 7. */
ModalModel detuned (const ModalModel&, const DetuningSpread&, std::uint64_t seed);
} // namespace antinode
