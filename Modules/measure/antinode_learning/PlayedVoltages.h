#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

namespace antinode
{
/** Band-limited voltages at the places of Gauss and Legendre between their samples: what modes are integrated with.
    They end with the last voltage but a tail of the band limit; from there on modes decay freely. */
class PlayedVoltages
{
public:
    static constexpr Eigen::Index places = 4; ///< Between two samples: ForceTaps::gaussPlaces.

    /** @param voltages  N_b x N_s, V, before and after which there are none [worker] */
    PlayedVoltages (const Eigen::MatrixXd& voltages, double sampleRate);

    /** The same, and what ceramics can add by distortion.
        @param cubes  as many, V^3, as cubedVoltages; or none [worker] */
    PlayedVoltages (const Eigen::MatrixXd& voltages, const Eigen::MatrixXd& cubes, double sampleRate);

    /** The voltages that linear ceramics would need to act like ceramics that distort, U + c U^3; the same where cubes
        are not known.
        @param distortions  c, N_b, 1/V^2
        [worker] */
    PlayedVoltages distorted (const Eigen::VectorXd& distortions) const;

    /** As many as were played. */
    Eigen::Index samples() const { return count; }

    /** After so many samples nothing drives the modes. */
    Eigen::Index drivenSamples() const { return driven; }

    Eigen::Index ceramics() const { return values.cols(); }
    double sampleRate() const { return rate; }

    /** One ceramic's, N_d * places, N_d the driven samples: those after sample n begin at n * places. */
    auto of (Eigen::Index ceramic) const { return values.col (ceramic); }

    /** The same of its cube, V^3. */
    auto cubeOf (Eigen::Index ceramic) const { return cubed.col (ceramic); }

    bool hasCubes() const { return cubed.size() > 0; }

    /** A modal force: a row of participations in, N_d * places out. */
    Eigen::VectorXd force (const Eigen::RowVectorXd& participation) const { return values * participation.transpose(); }

    /** The same of all modes: N_m x N_b in, N_d * places x N_m out. [worker] */
    Eigen::MatrixXd forces (const Eigen::MatrixXd& participation) const;

private:
    Eigen::Index count, driven;
    Eigen::MatrixXd values, cubed; // N_d * places x N_b
    double rate;
};

/** The motion of one mode, sample by sample: its velocity, and how that changes with what describes the mode. */
struct ModeMotion
{
    Eigen::VectorXd velocity;    ///< N_s, m/s kg^1/2: that of sample n before the voltage of its interval acts.
    Eigen::VectorXd byFrequency; ///< The same per relative change of the frequency; empty where it is not wanted.
    Eigen::VectorXd byDamping;   ///< Per relative change of the damping ratio; empty where it is not wanted.
};

/** The motion of a mode under a force, from rest, for as long as it moves: until it has decayed to 1e-10 of what it
   was.
    @param force    as PlayedVoltages::force gives it; none after its end
    @param samples  how many at most
    @return         fewer samples than these where it has decayed before
    [worker] Docs/Theory.md, section 7.6. */
ModeMotion modeMotionUntilRest (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force,
                                double sampleRate, Eigen::Index samples, bool withChanges);

/** The same with zeros after its end: as many samples as are wanted. [worker] */
ModeMotion modeMotion (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force, double sampleRate,
                       Eigen::Index samples, bool withChanges);

/** The velocities of all modes, N_s x N_m. [worker] */
Eigen::MatrixXd modeVelocities (const ModalModel&, const PlayedVoltages&, Eigen::Index samples);

/** The cubes of band-limited voltages, without what they have beyond half the sample rate: what ceramics that distort
    add to their motion.
    @param voltages  V, N_b x N_s
    @return          V^3, N_b x N_s
    [worker] Docs/Theory.md, section 7.6. */
Eigen::MatrixXd cubedVoltages (const Eigen::MatrixXd& voltages);
} // namespace antinode
