#pragma once

#include "SurfaceNode.h"

#include <antinode_engine/RealtimePlate.h>

#include <atomic>
#include <memory>

namespace antinode
{
/** The plate under the voltages: the velocity at each probe, a channel each, for a monitor. */
class PlateNode : public SurfaceNode
{
public:
    /** @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2 */
    PlateNode (std::shared_ptr<const ModalModel>, Eigen::MatrixXd probeShapes);
    ~PlateNode() override;
    PlateNode (const PlateNode&) = delete;
    PlateNode& operator= (const PlateNode&) = delete;

    std::string name() const override { return "Plate"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return static_cast<int> (probeShapes.rows()); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;

    /** @throws InputError  as RealtimePlate */
    void setProbes (Eigen::MatrixXd probeShapes) override;
    void modalVelocities (std::span<double> velocities) const override { plate->modalVelocities (velocities); }

private:
    RealtimePlate& newestPlate();

    std::shared_ptr<const ModalModel> model;
    Eigen::MatrixXd probeShapes;
    double sampleRate = 0;
    std::unique_ptr<RealtimePlate> plate;
    std::atomic<RealtimePlate*> next { nullptr }, replaced { nullptr }; ///< To the audio thread, and back to be freed.
};
} // namespace antinode
