#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/SampledVoltages.h>
#include <antinode_tracks/Waveforms.h>

#include <Eigen/Core>

namespace antinode
{
/** What a surface does with voltages, at points. */
struct PlayedTracks
{
    double sampleRate = 0;           ///< Hz
    Eigen::Index trigger = 0;        ///< The sample of the trigger.
    Eigen::MatrixXd displacements;   ///< points x N_s, m
    double modalRate = 0;            ///< Hz, of the modal velocities: a whole part of the sample rate.
    Eigen::MatrixXd modalVelocities; ///< N_c x N, m/s kg^1/2, from the first sample on.
};

/** Plays voltages on a surface, mode by mode from sample to sample, and lets it ring: what happens at the touched
   points, which may move. Knows nothing of a design.
    @param ringing     s after the last voltage
    @throws InputError  as requirePlaces
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 6.2. */
PlayedTracks playTracks (const ModalModel&, const WaveformsDescription&, const SampledVoltages&, double ringing);
} // namespace antinode
