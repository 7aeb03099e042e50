#pragma once

#include "FingerFilters.h"

#include <Eigen/Core>

namespace antinode
{
/** Filters as they are played: one matrix, whose product with the inputs' past is a sample of all voltages. */
struct FilterBank
{
    Eigen::Index inputs = 0, taps = 0, factor = 1;
    Eigen::MatrixXf values; ///< N_b x (inputs taps), V/m: for each input its taps, that of the oldest sample first.
};

/** [worker] */
FilterBank filterBank (const FingerFilters&);
} // namespace antinode
