#pragma once

#include "SurfaceNode.h"

#include <antinode_engine/PlateModel.h>

#include <atomic>
#include <memory>

namespace antinode
{
/** The surface as a render has it: exact for the band-limited voltage that the samples stand for, and therefore 15
    samples late. What PlateNode does without this delay, and at a fraction of the cost, is a few parts in a
    thousand away. */
class PlateModelNode : public SurfaceNode
{
public:
    /** @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2 */
    PlateModelNode (std::shared_ptr<const ModalModel>, Eigen::MatrixXd probeShapes);
    ~PlateModelNode() override;
    PlateModelNode (const PlateModelNode&) = delete;
    PlateModelNode& operator= (const PlateModelNode&) = delete;

    std::string name() const override { return "Surface"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return probes; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override { plate->reset(); }
    std::int64_t latencySamples() const override { return plate->latencySamples(); }
    void setProbes (Eigen::MatrixXd probeShapes) override;
    void modalVelocities (std::span<double> velocities) const override;

private:
    void takeProbes();

    std::shared_ptr<const ModalModel> model;
    int probes;
    std::unique_ptr<const Eigen::MatrixXd> shapes;
    std::unique_ptr<PlateModel> plate;
    Eigen::MatrixXd voltages, motion, heard; ///< Of one tile.
    std::atomic<const Eigen::MatrixXd*> next { nullptr },
        replaced { nullptr }; ///< To the audio thread, and back to be freed.
};
} // namespace antinode
