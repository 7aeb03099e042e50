#pragma once

#include "FocusDescription.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <cstddef>
#include <vector>

namespace antinode
{
/** Which samples are free: those up to the focus. Band-limited ones go on beyond it as their own mirror image, which
   has no slope at the focus: a step there would move all modes far above those that are guarded. */
struct SampleRange
{
    Eigen::Index focus = 0;    ///< The number of samples before the focus.
    Eigen::Index count = 0;    ///< Of the free ones.
    Eigen::Index mirrored = 0; ///< Behind the focus, of those that act before it.
};

/** @param rows  that are to be kept of all samples
    @throws InputError  where there is no sample rate, or not enough memory
    [any] */
SampleRange findSampleRange (const FocusDescription&, Playback, std::size_t rows);

/** Modal velocities at the focus per free sample, with what its mirror image adds. modes x count [worker] */
Eigen::MatrixXd velocityWeights (const ModalModel&, const std::vector<int>& modes, Playback, const SampleRange&);

/** The same of all samples that act before the focus, each for itself. modes x (count + mirrored) [worker] */
Eigen::MatrixXd plainVelocityWeights (const ModalModel&, const std::vector<int>& modes, Playback, const SampleRange&);

/** How much of a free sample its image so many samples behind the focus has: 1 where it acts before the focus, then
    less. [any] */
double mirrorLevel (const SampleRange&, Eigen::Index behind);

/** How many samples the mirror image has behind the focus. [any] */
Eigen::Index mirrorLength (const SampleRange&);

/** Free samples, one waveform a row, and their mirror image, which fades behind those that act before the focus. [any]
 */
Eigen::MatrixXd withMirrorImage (const Eigen::MatrixXd& samples, const SampleRange&);

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

/** Each sample follows a free one by a low-pass of first order, from rest: so many free samples are its time constant.
   A jump becomes an edge, and limits that the free samples keep are kept.
    @param samples       N_b x N_s
    @param timeConstant  0: the samples as they are
    [any] Docs/Theory.md, section 4.9. */
Eigen::MatrixXd withSmoothEdges (const Eigen::MatrixXd& samples, double timeConstant);

/** The adjoint: what values for each smooth sample are for each free one.
    @param weights  any x N_s; where it is moved, it is the result
    [any] */
Eigen::MatrixXd smoothEdgesAdjoint (Eigen::MatrixXd weights, double timeConstant);

/** dU/dt of what band-limited samples stand for, V/s, from the rest before them to the rest behind. */
struct SampledSlopes
{
    Eigen::MatrixXd values;     ///< N_b x N, at 8 places per sample.
    double first = 0, last = 0; ///< s from the trigger: the times of the first and the last one.
};

/** [worker] */
SampledSlopes slopesOf (const SampledVoltages&);

/** The same samples up to those that act before the focus, and then a fade to 0 that keeps the slew limits.
    @param slewLimits  N_b, V/s; 0: none
    [any] */
SampledVoltages withSlowEnd (const SampledVoltages&, const Eigen::VectorXd& slewLimits, double focusTime);
} // namespace antinode
