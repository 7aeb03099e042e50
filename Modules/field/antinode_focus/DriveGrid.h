#pragma once

#include <antinode_model/Oscillation.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Samples of one cycle of the fastest oscillation on the grid on which voltage limits are imposed. How fast an
   oscillation is says the modulus of its exponent: a release bends by its decay as well as by its frequency. */
constexpr int gridSamplesPerCycle = 32;

/** The factor of the grid's limit that makes the limit hold between its samples too: cos (pi / 32) = 0.9952 at 32 per
   cycle. [any] Docs/Theory.md, section 4.6. */
double gridLimitMargin (int samplesPerCycle = gridSamplesPerCycle);

/** Drives sampled from `first` to `last` inclusive, fine enough for gridLimitMargin.
    @param drives  the oscillations of each drive
    @return        drives x N_s
    [worker] Docs/Theory.md, section 4.6. */
Eigen::MatrixXd sampleDrives (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle = gridSamplesPerCycle);

/** The slopes of the drives on the same grid, 1/s. [worker] Docs/Theory.md, section 4.6. */
Eigen::MatrixXd sampleSlopes (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle = gridSamplesPerCycle);
} // namespace antinode
