#pragma once

#include "FreeWaveform.h"
#include "SampleRange.h"

#include <antinode_allocation/BoundedWaveform.h>

#include <vector>

namespace antinode
{
/** What a free waveform was made for. What it refers to outlives it. */
struct QuietTask
{
    const ModalModel& model;
    const FocusDescription& description; ///< With `felt`.
    const BoundedWaveformProblem& problem;
    const std::vector<int>& modes; ///< Of the problem's rows.
    SampleRange range;
};

/** Changes a free waveform so that less is felt elsewhere. Rows keep their values to rounding and limits are kept; the
   waveform goes on after the focus.
    @throws InputError  as feltLines; Cancelled when a watch of this thread says no
    [worker] Docs/Theory.md, section 4.14. */
void makeQuieter (FreeWaveform&, const QuietTask&);
} // namespace antinode
