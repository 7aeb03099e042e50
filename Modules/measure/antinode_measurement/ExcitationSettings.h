#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace antinode
{
/** The excitation signal of a ceramic. Docs/Theory.md, section 8.8. */
enum class ExcitationSignal
{
    multisine, ///< Periodic: all lines of the band at once, no leakage.
    sweep,     ///< Exponential: separates harmonics from the linear response.
    noise      ///< White within the band.
};

/** The settings of an excitation. */
struct ExcitationSettings
{
    ExcitationSignal signal = ExcitationSignal::multisine;
    double sampleRate = 96000;                              ///< Hz
    double lowestFrequency = 100, highestFrequency = 20000; ///< Hz: the band of the responses.
    double resolution = 1;    ///< Hz: lines lie at most so far apart; a block lasts 1/resolution or a little longer.
    int periods = 4;          ///< Blocks that are measured; of a sweep, how often it is repeated.
    int settlingPeriods = 1;  ///< Blocks before them in which the surface settles; of multisine and noise.
    double sweepDuration = 4; ///< s
    bool hasOddGrid = false;  ///< A multisine of odd lines with gaps at random: shows even and odd distortion.
    std::uint64_t seed = 1;   ///< Of noise and gaps.
    Eigen::VectorXd levels;   ///< N_b: peak voltage of each ceramic, V, more than 0.
};
} // namespace antinode
