#pragma once

#include "SampleRange.h"

#include <antinode_model/SampledVoltages.h>

#include <vector>

namespace antinode
{
/** How many samples are played for so many free ones: all of a finer grid are interpolated, and some are played. */
struct SampleRatio
{
    Eigen::Index played = 1, free = 1;

    bool isOne() const { return played == free; }
    double value() const { return static_cast<double> (played) / static_cast<double> (free); }
};

/** Free samples at a fraction of the rate at which they are played. Samples in between are interpolated, so that a
   waveform near its least voltage has no sharper edges at 192 kHz than at 48 kHz: those would move modes far beyond the
   known ones. */
struct SparseSamples
{
    SampleRatio ratio; ///< At least 1.
    Playback playback; ///< What is played.
    SampleRange range; ///< Of the free samples, at their own rate.

    /** Hz: of the free samples. */
    double freeRate() const { return playback.sampleRate / ratio.value(); }

    /** Where a played sample lies, in free ones. */
    double placeOf (Eigen::Index played) const;
};

/** @param rows  that are to be kept of all samples
    @throws InputError  as findSampleRange
    [any] Docs/Theory.md, section 4.9. */
SparseSamples sparseSamples (const FocusDescription&, Playback, std::size_t rows, SampleRatio);

/** The ratios that leave a rate of three times a frequency, Hz, largest first, and then 1; of held samples 1 alone.
   [any] */
std::vector<SampleRatio> sparseRatios (Playback, double frequency);

/** Modal velocities at the focus per free sample, exact for what is played. modes x range.count [worker] */
Eigen::MatrixXd velocityWeights (const ModalModel&, const std::vector<int>& modes, const SparseSamples&);

/** What is played. @param samples  N_b x range.count @param focusTime  s [worker] */
SampledVoltages playedSamples (const Eigen::MatrixXd& samples, const SparseSamples&, double focusTime);
} // namespace antinode
