#pragma once

#include <antinode_model/ModalModel.h>

#include <array>

namespace antinode
{
/** Band-limited voltages at the places of Gauss and Legendre between their samples: what modes are integrated with. */
class PlayedVoltages
{
public:
    static constexpr Eigen::Index places = 4; ///< Between two samples.

    /** @param voltages  N_b x N_s, V, before and after which there are none [worker] */
    PlayedVoltages (const Eigen::MatrixXd& voltages, double sampleRate);

    Eigen::Index samples() const { return count; }
    Eigen::Index ceramics() const { return values.cols(); }
    double sampleRate() const { return rate; }

    /** One ceramic's, N_s * places: those after sample n begin at n * places. */
    auto of (Eigen::Index ceramic) const { return values.col (ceramic); }

    /** A modal force per participation: a row of participations in, N_s * places out. */
    Eigen::VectorXd force (const Eigen::RowVectorXd& participation) const { return values * participation.transpose(); }

private:
    Eigen::MatrixXd values; // N_s * places x N_b
    Eigen::Index count;
    double rate;
};

/** The motion of one mode, sample by sample: its velocity, and how that changes with what describes the mode. */
struct ModeMotion
{
    Eigen::VectorXd velocity;    ///< N_s, m/s kg^1/2: that of sample n before the voltage of its interval acts.
    Eigen::VectorXd byFrequency; ///< The same per relative change of the frequency; empty where it is not wanted.
    Eigen::VectorXd byDamping;   ///< Per relative change of the damping ratio; empty where it is not wanted.
};

/** The motion of a mode under a force, from rest.
    @param force    as PlayedVoltages::force gives it
    @param samples  how many of the first
    [worker] Docs/Theory.md, section 7.6. */
ModeMotion modeMotion (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force, double sampleRate,
                       Eigen::Index samples, bool withChanges);

/** The velocities of all modes, N_s x N_m. [worker] */
Eigen::MatrixXd modeVelocities (const ModalModel&, const PlayedVoltages&, Eigen::Index samples);
} // namespace antinode
