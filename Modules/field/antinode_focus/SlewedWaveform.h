#pragma once

#include "WaveformTask.h"

#include <utility>

namespace antinode
{
/** The waveform of a task that keeps the slew limits of the model, at 8 places per sample, as solveWithEdges gives it
   where it keeps them.
    @return  with the time constant of its edges, s
    @throws LimitError  where none was found; InputError as solveWithEdges
    [worker] Docs/Theory.md, section 4.9. */
std::pair<SolvedWaveform, double> solveWithinSlews (const WaveformTask&);
} // namespace antinode
