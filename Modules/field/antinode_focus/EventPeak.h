#pragma once

#include "FocusScore.h"

namespace antinode
{
/** Values at a place between samples, by the interpolation of a band-limited playback.
    @param samples   rows x N_s
    @param position  in samples, 0 to N_s - 1
    @return          one value per row: the sample itself where the position is that of one
    [worker] Docs/Theory.md, section 6.2. */
Eigen::VectorXd betweenSamples (const Eigen::MatrixXd& samples, double position);

/** The value of largest magnitude of one row of samples, between them too. */
struct SamplePeak
{
    double position = 0; ///< In samples.
    double value = 0;    ///< With its sign.
};

/** @param samples  N_s, at least 1  [worker] */
SamplePeak largestInTime (const Eigen::RowVectorXd& samples);

/** What modes did, sample by sample. Refers to the samples. */
struct RecordedMotion
{
    const Eigen::MatrixXd& modalVelocities; ///< N_c x N_s, m/s kg^1/2
    double sampleRate = 0;                  ///< Hz
};

/** The velocity of largest magnitude anywhere on the surface at any time, between points and samples too, and its place
    and time: searched on even places at every so many samples, and refined there by the mode shapes. Within 1e-3.
    @param outside      focal spots that are left out at all times; their boundaries are not
    @param first, last  samples, the search includes both
    @return             0 m/s where nothing lies outside
    [worker] Docs/Theory.md, section 5. */
FieldPeak largestInEvent (const ModalModel&, const RecordedMotion&, const std::vector<FocalSpot>& outside,
                          Eigen::Index first, Eigen::Index last);
} // namespace antinode
