#pragma once

#include "Detuning.h"
#include "FreeSamples.h"

#include <antinode_allocation/BoundedWaveform.h>
#include <antinode_model/ModalModel.h>

#include <optional>
#include <vector>

namespace antinode
{
/** Free samples with the limits of all that is played. */
struct PlayedProblem
{
    SparseSamples sparse;
    BoundedWaveformProblem hard, all; ///< Hard rows alone, and with those of guards behind them.
    /** Hard rows of every sample that is played: what is proven with them holds for all waveforms of that rate. None
        where every sample is free. */
    std::optional<BoundedWaveformProblem> everySample;
    double focusTime = 0; ///< s
    /** Time constant, in free samples, of the low-pass through which they are played; 0: none. Rows are those of the
        free ones. */
    double edge = 0;
    bool isRobust = false; ///< What is proven of samples that are as tolerant is asked for.
};

/** Free samples, and what is played of them. */
struct PlayedWaveform
{
    BoundedWaveform free;
    SampledVoltages played;
    double peak = 0;          ///< Of what is played, as a share of the limits.
    bool isLimited = false;   ///< Whether limits shape it, those of single samples among them.
    bool isNear = false;      ///< Whether it keeps the limits, and is as near to its bound as was asked for.
    double tolerantBound = 0; ///< Of robust problems: no free samples that are as tolerant have a lower peak. A share
                              ///< of the limits.
};

/** Between free samples the waveform is higher than at them: their limits are lowered until all that is played keeps
    its own.
    [worker] Docs/Theory.md, section 4.9. */
PlayedWaveform solvePlayed (const PlayedProblem&);

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
