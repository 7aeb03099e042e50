#pragma once

#include "FingerFilters.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Filters as they are played: one matrix, whose product with the inputs' past is a sample of all voltages. */
struct FilterBank
{
    Eigen::Index inputs = 0, taps = 0, factor = 1;
    Eigen::MatrixXf values;  ///< N_b x (inputs taps), V/m: for each input its taps, that of the oldest sample first.
    std::vector<bool> moves; ///< Per input: false where all of its taps are 0.
};

/** A bank with an input for each track. [worker] */
FilterBank filterBank (const FingerFilters&);

/** A bank that moves nothing. [worker] */
FilterBank silentBank (Eigen::Index ceramics, Eigen::Index inputs, FilterTiming);

/** A bank with more inputs than tracks; those without one move nothing.
    @param inputOfTrack  each below `inputs`
    [worker] */
FilterBank filterBank (const FingerFilters&, const std::vector<Eigen::Index>& inputOfTrack, Eigen::Index inputs);
} // namespace antinode
