#pragma once

#include "Detuning.h"
#include "DriveAllocation.h"
#include "FocusDescription.h"

#include <antinode_allocation/Allocation.h>
#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** The meaning of the rows of an allocation problem. */
struct RowOrigin
{
    std::vector<int> controlled, guards; ///< Modes.
    DriveList drives;
    double time = 0; ///< s from the trigger: that of the focus.
    Playback playback;
};

/** An allocation problem with guard rows for what errors of the device do to the velocities at the focus: the sum of
   their squares is the expected squared error of all modes, in (m/s)^2 kg. Hard rows stay as they are. Rows that cost
   less than the energy that it takes to move them are left out, and of the others the weakest beyond 4000.
    @param problem  exact rows, with guards
    @throws InputError  as solveAllocation
    [worker] Docs/Theory.md, section 7.5. */
AllocationProblem withRobustRows (AllocationProblem problem, const ModalModel&, const RowOrigin&, const Robustness&);

/** The responses of modes at the focus to each drive on deviating devices: rows, each weighted by the root of its
   share, whose squares, summed, are expected squares over errors of frequency and damping. */
struct DetunedResponses
{
    std::vector<int> modes;              ///< Controlled ones, then guards.
    std::vector<Eigen::MatrixXd> values; ///< Of each mode, rows x drives: the velocity per unit participation.
    /** Of each mode, rows x drives: its error. Of a controlled mode that is the difference from the nominal device,
        whose velocity is met; of a guard it is all. */
    std::vector<Eigen::MatrixXd> errors;
};

/** By the product of two Gauss-Hermite rules of three points, for frequency and damping: exact where responses are
   polynomials of degree 2 in either. [worker] Docs/Theory.md, section 7.5. */
DetunedResponses detunedResponses (const ModalModel&, const RowOrigin&, const DetuningSpread&);
} // namespace antinode
