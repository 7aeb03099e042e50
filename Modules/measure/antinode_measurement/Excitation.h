#pragma once

#include "ExcitationSettings.h"

#include <vector>

namespace antinode
{
/** The run of one ceramic in a measurement: all ceramics play the same signal one after the other, each at its own
   level.

    A run starts with the signal and ends with silence, during which the surface comes to rest and delayed samples
   arrive. The sync channel plays the same signal at the same time: looped back to an input, it gives the latency of
   recordings.
*/
struct Excitation
{
    ExcitationSettings settings;
    Eigen::VectorXd signal;     ///< Of one run without its silence; the waveform between the samples has a peak of 1.
    Eigen::Index block = 0;     ///< Samples of a period, of a block of noise, of a sweep with the silence after it.
    Eigen::Index runLength = 0; ///< Samples of one run: from one ceramic's first sample to the next one's.
    std::vector<Eigen::Index> lines; ///< Of a block of `lineBlock` samples: those that are measured, ascending.
    Eigen::Index lineBlock = 0;      ///< Lines lie sampleRate / lineBlock apart.
    double crestFactor = 0;          ///< Peak over effective value while it plays.

    /** Hz, of line l of a block. */
    double lineFrequency (Eigen::Index line) const
    {
        return static_cast<double> (line) * settings.sampleRate / static_cast<double> (lineBlock);
    }

    Eigen::Index ceramics() const { return settings.levels.size(); }
};

/** The level at which the sync channel plays, of full scale. */
inline constexpr double syncLevel = 0.5;

/** An excitation as the settings ask for it.
    @param voltageLimits  N_b: what no sample, nor the waveform between samples, exceeds, V
    @throws InputError    naming the first setting that is not usable, and what is
    [worker] Docs/Theory.md, section 8.8. */
Excitation makeExcitation (const ExcitationSettings&, const Eigen::VectorXd& voltageLimits);

/** An excitation as it was made before, with the signal that was played.
    @throws InputError  as makeExcitation, and where the signal is not as long as the settings make it or its samples
   exceed 1 [worker] */
Excitation excitationWith (const ExcitationSettings&, const Eigen::VectorXd& voltageLimits,
                           const Eigen::VectorXd& signal);

/** The voltages played in a ceramic's run.
    @param fullScale  The voltage of a sample of 1, V
    @return           (N_b + 1) x runLength samples of full scale: ceramics, then the sync channel
    [worker] */
Eigen::MatrixXd playedRun (const Excitation&, Eigen::Index ceramic, double fullScale);

/** The frequencies of the lines, Hz. [any] */
Eigen::VectorXd measuredFrequencies (const Excitation&);
} // namespace antinode
