#pragma once

#include "DetuningSpread.h"
#include "SparseSamples.h"

#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** Where the rows of a problem of samples come from. It refers to its parts. */
struct SampledRows
{
    const ModalModel& model;
    const std::vector<int>& modes; ///< Of the rows, in their order: controlled ones, then guards.
    const SparseSamples& sparse;
};

/** A problem of free samples with soft rows for what errors of the device do to the velocities at the focus: their cost
   is half the price times the expected squared error of all modes. What costs less than the energy that moves it is
   left out.
    @param problem  hard rows, then those of guards
    @param price    of a squared error, V^2 per (m/s)^2 kg
    @throws InputError  as velocityWeights
    [worker] Docs/Theory.md, section 7.5. */
BoundedWaveformProblem withTolerance (BoundedWaveformProblem problem, const SampledRows&, const DetuningSpread&,
                                      double price);
} // namespace antinode
