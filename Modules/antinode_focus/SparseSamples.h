#pragma once

#include "SampleRange.h"

#include <antinode_model/SampledVoltages.h>

namespace antinode
{
/** Free samples at a whole fraction of the rate at which they are played. Samples in between are interpolated, so that
   a waveform near its least voltage has no sharper edges at 192 kHz than at 48 kHz: those would move modes far beyond
   the known ones. */
struct SparseSamples
{
    Eigen::Index factor = 1; ///< Samples that are played for each free one.
    Playback playback;       ///< What is played.
    SampleRange range;       ///< Of the free samples, at their own rate.
};

/** @param factor  at least 1
    @param rows    that are to be kept of all samples
    @throws InputError  as findSampleRange
    [any] Docs/Theory.md, section 4.9. */
SparseSamples sparseSamples (const FocusDescription&, Playback, std::size_t rows, Eigen::Index factor);

/** The largest factor that leaves a rate of three times a frequency, Hz; 1 for held samples. [any]
 */
Eigen::Index largestFactor (Playback, double frequency);

/** Modal velocities at the focus per free sample, exact for what is played. modes x range.count [worker] */
Eigen::MatrixXd velocityWeights (const ModalModel&, const std::vector<int>& modes, const SparseSamples&);

/** What is played. @param samples  N_b x range.count @param focusTime  s [worker] */
SampledVoltages playedSamples (const Eigen::MatrixXd& samples, const SparseSamples&, double focusTime);
} // namespace antinode
