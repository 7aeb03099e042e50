#pragma once

#include "DriveAllocation.h"

#include <complex>

namespace antinode
{
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
} // namespace antinode
