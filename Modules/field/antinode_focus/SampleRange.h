#pragma once

#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>

#include <Eigen/Core>

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
} // namespace antinode
