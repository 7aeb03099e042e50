#pragma once

#include <cstdint>

namespace antinode
{
/** Sine bursts that tell which ceramic is which, by ear or finger: 200 Hz, twice a second, with soft edges. Each sample
   comes from its number, so the tone does not depend on blocks. */
class IdentifyTone
{
public:
    static constexpr double frequency = 200;     ///< Hz
    static constexpr double period = 0.5;        ///< s, from burst to burst
    static constexpr double burst = 0.2;         ///< s
    static constexpr double edge = 0.02;         ///< s, of a burst's rise and of its fall
    static constexpr double maximumVolts = 5;    ///< V
    static constexpr double shareOfLimit = 0.05; ///< Of the ceramic's own limit.

    /** V, for a ceramic with such a limit. [any] */
    static double amplitude (double voltageLimit);

    /** @param sample  since the tone began, 0 or more  @return  -1 to 1 [audio thread] */
    static double at (std::int64_t sample, double sampleRate);
};
} // namespace antinode
