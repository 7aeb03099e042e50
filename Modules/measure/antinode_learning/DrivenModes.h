#pragma once

#include "MovingMode.h"
#include "PlayedVoltages.h"

namespace antinode
{
/** Motions of modes, or what changes them, one a column: sample by sample while voltages drive them, and how they decay
    from there on. */
struct Histories
{
    Eigen::MatrixXd driven;       ///< N_d x P
    std::vector<FreeDecay> after; ///< P: from sample N_d on.

    /** The parts of `after`, 4 x P. [any] */
    Eigen::Matrix4Xd parts() const;
};

/** How each mode of a device moves under voltages, from rest: each N_m. */
struct DrivenModes
{
    Histories velocity;    ///< m/s kg^1/2
    Histories byFrequency; ///< The same per relative change of the frequency.
    Histories byDamping;   ///< Per relative change of the damping ratio.
};

/** @param samples  how many at most while voltages drive the modes
    [worker] Docs/Theory.md, section 7.6. */
DrivenModes driveModes (const ModalModel&, const PlayedVoltages&, Eigen::Index samples);

/** The velocities of single modes, each under ceramics by weights of its own.
    @param modes           P
    @param participations  P x N_b
    @param samples         as driveModes
    [worker] */
Histories drivenBy (const ModalModel&, const std::vector<Eigen::Index>& modes, const Eigen::MatrixXd& participations,
                    const PlayedVoltages&, Eigen::Index samples);

/** The velocities of all modes. [worker] */
Histories modeHistories (const ModalModel&, const PlayedVoltages&, Eigen::Index samples);

/** The velocities of a mode under each ceramic alone: N_b. [worker] */
Histories drivenByEachCeramic (const ModalModel&, Eigen::Index mode, const PlayedVoltages&, Eigen::Index samples);

/** The velocities of all modes under the cube of one ceramic's voltage, per unit of its distortion: N_m. [worker] */
Histories drivenByCube (const ModalModel&, const PlayedVoltages&, Eigen::Index ceramic, Eigen::Index samples);

/** The motions of all modes when each ceramic alone has driven them, as complex numbers of which the velocity is the
    real part: N_m x N_b. */
struct LastMotions
{
    Eigen::MatrixXcd byVoltages;
    Eigen::MatrixXcd byCubes; ///< Per unit of the distortion.
};

/** @param voltages  with their cubes
    @param samples   until the motions, how many at most while voltages drive the modes
    [worker] */
LastMotions lastMotions (const ModalModel&, const PlayedVoltages& voltages, Eigen::Index samples);

/** The logarithm of what a sample does to a mode that nothing drives: pole times the sample's length. [any] */
std::complex<double> decayLogarithm (const ModalModel&, Eigen::Index mode, double sampleRate);

/** Of all modes. [any] */
Eigen::VectorXcd decayLogarithms (const ModalModel&, double sampleRate);
} // namespace antinode
