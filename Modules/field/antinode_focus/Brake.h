#pragma once

#include "DriveAllocation.h"
#include "FocusDesign.h"

#include <complex>
#include <optional>
#include <vector>

namespace antinode
{
/** Adds to a design, within the voltage limits, what brings all modes that still matter by then to rest after the last
   focus: their velocities and displacements are exactly 0 at the end, the other modes are guarded. Begins when the
   drives are released. Where the limits do not allow rest in the requested time, the brake takes longer and a warning
   says so.
    @throws InputError  when the requested time is too short for any brake, or as solveAllocation
    [worker] Docs/Theory.md, section 3.4. */
void appendBrake (FocusDesign&, const ModalModel&);

/** Whether a focus asks for a brake. [any] */
bool hasBrake (const TransientChoice&);

/** The brake of one mode: e^{-decay tau} cos (b tau) and sin (b tau), from `start` on, with a smooth onset, released so
   that all is over at `end`. */
struct BrakeWindow
{
    double start = 0, end = 0; ///< s from the trigger; at least 2 releaseDuration() apart.
    double decay = 0;          ///< 1/s, of the envelope: at least 0.
};

/** The two drives with which a mode is braked, 90 degrees apart: sum of X e^{p tau} (1 - e^{-r tau})^2 and its release,
   X = 1 and -j, p = -decay + j b. Neither value nor slope jumps anywhere.
    @param decayRate, dampedFrequency  a (1/s) and b (rad/s) of the mode
    [any] Docs/Theory.md, section 3.4. */
DriveList brakeDrives (int mode, double decayRate, double dampedFrequency, const BrakeWindow&);

/** The fraction of a brake's effect on its own mode from the part that rotates against it; needed by a brake that
   starts later.
    @param pole    s of the mode
    @param drives  its two drives
    @param force   Z, the modal forces with which both act: Z = first - j second
    @return        rho, 0 where there is no force; its magnitude is below 1
    [any] Docs/Theory.md, section 6.6. */
std::complex<double> counterShare (std::complex<double> pole, const DriveList& drives, std::complex<double> force);

/** The same of a complex mode, which sees what rotates with it and what rotates against it by different forces.
    @param counterForce  what stands for the conjugate of Z
    [any] Docs/Theory.md, section 6.6. */
std::complex<double> counterShare (std::complex<double> pole, const DriveList& drives, std::complex<double> force,
                                   std::complex<double> counterForce);

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
