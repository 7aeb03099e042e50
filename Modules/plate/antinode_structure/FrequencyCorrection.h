#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** Whether modes have other frequencies than those of a thin plate of one section: soft layers, Mindlin's theory.
    [any] */
bool needsCorrection (const StructureCommon&);

/** What is solved in place of a description that needs correction: a thin plate whose soft layers are taken at a wave
    number, with a maximum frequency that such a plate has where the wanted one lies.
    @param waveNumber  in the middle of the modes, rad/m; where the description has a maximum frequency, half of the
                       wave number there is taken
    [any] Docs/Theory.md, section 1.15. */
StructureCommon asSolved (StructureCommon, double waveNumber);

/** Gives solved modes the frequencies that waves of their length have on the bare plate, adds the damping of soft
   layers and scales participation by the moment per volt at that length. Parts with ceramics are taken to change as the
   bare plate does; shapes stay.
    @param common  as solved
    [worker] Docs/Theory.md, sections 1.7 and 1.15. */
void correctFrequencies (ModalModel&, const StructureCommon&);
} // namespace antinode
