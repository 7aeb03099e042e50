#pragma once

#include "DriveAllocation.h"
#include "FocusDesign.h"

#include <optional>
#include <vector>

namespace antinode
{
/** One way to brake. */
struct BrakeAttempt
{
    double duration = 0;         ///< T_b, s after the last focus.
    std::optional<double> brake; ///< gamma'; none: one envelope for all modes,
    double folds = 0;            ///< which decays by this many e-folds.
};

/** An attempt worked out. */
struct BrakeProblem
{
    std::vector<int> modes; ///< That still move the surface by the end.
    DriveList drives;       ///< Two a mode.
    AllocationProblem allocation;
};

/** The problem that brings the modes of a design to rest by the end of an attempt: drives, hard rows of velocities and
   displacements, guards for the other modes, limits. Without modes there is no allocation problem.
    @throws InputError  as rowResponses
    [worker] Docs/Theory.md, section 3.4. */
BrakeProblem brakeProblem (const FocusDesign&, const ModalModel&, const BrakeAttempt&);

/** Tells every brake what a later begin must know of it (Oscillation::counterShare).
    @param matrix  the problem's allocation, N_b x drives, V
    [worker] Docs/Theory.md, section 6.6. */
void addCounterShares (BrakeProblem&, const ModalModel&, const Eigen::MatrixXd& matrix);
} // namespace antinode
