#pragma once

#include "Bench.h"

#include <antinode_learning/LearningPasses.h>

namespace antinode
{
/** How passes are played on a bench. */
struct PassPlaySettings
{
    double sampleRate = 96000;  ///< Hz
    double silence = 0.05;      ///< s before the voltages: from it the noise of the sensors is measured.
    double longestDelay = 0.03; ///< s: recorded for so long after the voltages.
    bool usesSync = true;       ///< Where the bench records its sync channel.
};

/** Plays the passes of learnFocus on a bench: silence, the voltages, silence. Each sensor's noise is what it records
   before anything is played, at least 80 dB below its signal. Where the bench records its sync channel the delay is
   that of a burst of noise on it; else it is left to be looked for, up to the longest.
    @param bench    stays as long as the result
    @param sensors  how many are recorded
    @return         throws InputError as Bench::playTogether
    [worker] */
PassPlayer playPasses (Bench& bench, Eigen::Index sensors, const PassPlaySettings&);
} // namespace antinode
