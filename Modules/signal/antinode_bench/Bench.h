#pragma once

#include <antinode_measurement/Excitation.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_model/ModalModel.h>

namespace antinode
{
/** Plays the run of a ceramic and records the sensors. */
class Bench
{
public:
    Bench() = default;
    virtual ~Bench() = default;
    Bench (const Bench&) = delete;
    Bench& operator= (const Bench&) = delete;

    /** The number of points recorded at once. */
    virtual Eigen::Index sensors() const = 0;

    /** The velocity beyond which a sensor's input clips, m/s. */
    virtual double fullScaleVelocity() const = 0;

    /** Plays a run while the sensors are at consecutive points.
        @return  as many sensors as points, and the sync channel where it is recorded
        @throws InputError  where it cannot be played
        [worker] takes as long as the run on a real bench */
    virtual RunRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint,
                               Eigen::Index points) = 0;

    /** Plays voltages on all ceramics at once while the sensors are at the first points.
        @param sync  N_s: what the sync channel plays, of full scale
        @return      as play gives it, of as many samples
        @throws InputError  where it cannot be played, or a voltage is beyond what a sample of 1 stands for
        [worker] takes as long as the voltages on a real bench */
    virtual RunRecording playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                                       Eigen::Index points) = 0;
};

/** A simulated bench with sensors at several points at once. */
class SimulatedBenchPlayer : public Bench
{
public:
    /** @param points  N_p x 2, m. @throws InputError  where one lies outside the surface [worker] */
    SimulatedBenchPlayer (ModalModel, const Eigen::MatrixX2d& points, SimulatedBenchSettings);

    /** @param shapes  N x N_m: what each sensor hears of each modal velocity */
    SimulatedBenchPlayer (ModalModel, Eigen::MatrixXd shapes, SimulatedBenchSettings);

    Eigen::Index sensors() const override;
    double fullScaleVelocity() const override;
    RunRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint, Eigen::Index points) override;

    /** Each time with noise of its own. */
    RunRecording playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                               Eigen::Index points) override;

private:
    ModalModel model;
    Eigen::MatrixXd shapes; ///< N_p x N_m
    SimulatedBenchSettings settings;
    std::uint64_t plays = 0; ///< Of all ceramics at once, so far.
};
} // namespace antinode
