#pragma once

#include <Eigen/Core>

namespace antinode
{
/** An exponential sweep whose harmonics start at phase 0 with it: sin (2 pi f_1 L exp (t/L)), f_1 L integral.

    It begins below the band and ends above it, and is faded in and out there. Novak, Lotton and Simon, J. Audio Eng.
   Soc. 63, 2015.
*/
struct Sweep
{
    double startFrequency = 0, endFrequency = 0; ///< Hz
    double rise = 0;                             ///< L, s: the time in which the frequency grows e times.
    Eigen::VectorXd samples;
};

/** A sweep through a band.
    @param duration  s, about: f_1 L is rounded
    @return          samples between -1 and 1
    [worker] Docs/Theory.md, section 8.8. */
Sweep makeSweep (double lowestFrequency, double highestFrequency, double duration, double sampleRate);
} // namespace antinode
