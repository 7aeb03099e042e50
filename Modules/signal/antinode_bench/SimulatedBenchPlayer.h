#pragma once

#include "Bench.h"

#include <antinode_measurement/SimulatedBench.h>
#include <antinode_model/ModalModel.h>

namespace antinode
{
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
