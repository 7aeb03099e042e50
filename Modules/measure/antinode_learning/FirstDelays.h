#pragma once

#include "LearnModes.h"

#include <vector>

namespace antinode
{
/** The delays that the first play may have, to be tried on its whole record, s: one where its beginning tells it, else
    the best few.
    @param deviations  of the nominal device
    @param recording   with the range of delays that is looked through; without one its own delay is given
    @throws InputError, Cancelled  as learnModes
    [worker] Docs/Theory.md, section 7.6. */
std::vector<double> firstDelays (const ModalModel& nominal, const std::vector<Sensor>&, const ModeSpread& deviations,
                                 const PlayedRecording& recording);
} // namespace antinode
