#pragma once

#include "FocusDesign.h"

#include <Eigen/Core>
#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <vector>

namespace antinode
{
/** Drives: the oscillations of each, which share a column of the allocation. */
using DriveList = std::vector<std::vector<Oscillation>>;

/** What drives have to reach: the controlled modes, ascending, and the foci by time with the modal velocities wanted,
   one where rows are not exact. What it refers to outlives it. */
struct DriveTask
{
    const ModalModel& model;
    const FocusDescription& description;
    const std::vector<int>& modes;
    const std::vector<FocusMoment>& moments;
    Playback playback;
};

/** When drives are looked at, s from the trigger. */
struct DriveSpan
{
    double first = 0, last = 0;
};

/** The voltage limit of each ceramic: what it can be given on the device, or the focus's limit where that is lower.
   N_b, V. [any] */
Eigen::VectorXd voltageLimits (const ModalModel&, const AllocationChoice&);

/** Whether any ceramic has a slew limit. [any] */
bool hasSlewLimits (const ModalModel&);

/** Puts drives into a problem, with all limits that they have to keep while they last, on the grid that these are
   tightened for.
    @param limits  N_b, V
    [worker] Docs/Theory.md, sections 4.1 and 4.6. */
void limitDrives (AllocationProblem&, const ModalModel&, const Eigen::VectorXd& limits, const DriveList&, DriveSpan);

/** The modes that are guarded: the lowest of those that are not controlled, as many as requested. [any] */
std::vector<int> guardModes (const ModalModel&, const std::vector<int>& controlled, const AllocationChoice&);

/** How long before the focus a waveform may begin that is not bound to cycles: the focus time, or less where a maximum
   duration or a window says so. s [any] */
double longestDrive (const FocusDescription&);

/** Allocates drives to ceramics so that the controlled modes have the wanted velocities at the time of every focus.
    @throws InputError  as solveAllocation
    [worker] Docs/Theory.md, section 4. */
Allocation allocateDrives (const DriveTask&, const DriveList&);

/** Drives mixed by a matrix, N_b x drives, as a program. [any] */
VoltageProgram makeProgram (const DriveList&, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& limits,
                            double focusTime);

/** Samples of one cycle of the fastest oscillation on the grid on which voltage limits are imposed. How fast an
   oscillation is says the modulus of its exponent: a release bends by its decay as well as by its frequency. */
constexpr int gridSamplesPerCycle = 32;

/** The factor of the grid's limit that makes the limit hold between its samples too: cos (pi / 32) = 0.9952.
    [any] Docs/Theory.md, section 4.6. */
double gridLimitMargin();

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
