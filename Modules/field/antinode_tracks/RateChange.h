#pragma once

#include <Eigen/Core>

namespace antinode
{
/** Samples of the slower rate to each side that a change of rate reaches, which is also its delay. */
inline constexpr Eigen::Index rateChangeReach = 5;

/** A low-pass for changes of rate by a whole factor: Kaiser's windowed sinc, flat to a quarter of the slower rate,
   below -70 dB from three quarters on.
    @param factor  at least 1
    @return  2 rateChangeReach factor + 1 taps at the faster rate, for interpolation; over the factor, for decimation
    [worker] Docs/Theory.md, section 4.16. */
Eigen::VectorXf rateChangeTaps (Eigen::Index factor);
} // namespace antinode
